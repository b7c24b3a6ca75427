// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>
#include <vector>

namespace limn {

/// A sentence, phrase or name for people as a value: an English pattern with places %1 to %9 and what stands
/// in them. The window says it in the user's language (`translated`); the command line and files say
/// `english()`.
class Message {
public:
  Message() = default;
  /// What no language changes: names, paths, what others say.
  Message(std::string text) : m_text(std::move(text)) {}
  Message(const char* text) : m_text(text) {}

  /// A pattern that `translations` holds in other languages: lupdate finds what stands here as a literal.
  static Message tr(const char* pattern);

  /// This with the next place filled. Counts stand in digits, other numbers with `decimals` behind the point,
  /// which is a comma where the user's language has one.
  Message arg(const Message& message) const;
  Message arg(std::integral auto count) const { return arg(Message(std::to_string(count))); }
  Message arg(double number, int decimals) const;

  /// This, what separates, and another; one of them alone where the other is empty.
  Message followedBy(const char* separator, const Message& next) const;

  bool empty() const { return m_text.empty(); }
  std::string english() const;

  enum class Kind { verbatim, number, pattern };
  Kind kind() const { return m_kind; }
  const std::string& text() const { return m_text; } ///< the pattern, or the text itself
  double number() const { return m_number; }
  int decimals() const { return m_decimals; }
  const std::vector<Message>& arguments() const { return m_arguments; }

  bool operator==(const Message&) const = default;

private:
  Kind m_kind = Kind::verbatim;
  std::string m_text;
  double m_number = 0.0;
  int m_decimals = 0;
  std::vector<Message> m_arguments;
};

} // namespace limn
