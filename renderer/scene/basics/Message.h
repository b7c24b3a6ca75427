// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <type_traits>
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

  /// A pattern that `app/translations` holds in other languages: lupdate finds what stands here as a literal.
  static Message tr(const char* pattern);

  /// A number with `decimals` behind the point, which is a comma where the user's language has one.
  static Message fixed(double number, int decimals);
  /// A number of so many digits that count, without trailing zeros.
  static Message rounded(double number, int digits);

  /// This with the next place, or the next ones, filled. Counts stand in digits.
  Message arg(const Message& message) const;
  template <class Count, std::enable_if_t<std::is_integral_v<Count>, int> = 0> // moc does not know concepts
  Message arg(Count count) const {
    return arg(Message(std::to_string(count)));
  }
  template <class First, class Second, class... More>
  Message arg(const First& first, const Second& second, const More&... more) const {
    return arg(first).arg(second, more...);
  }

  /// This, what separates, and another; one of them alone where the other is empty.
  Message followedBy(const char* separator, const Message& next) const;

  /// This with every text that no language changes put through a function.
  Message withVerbatim(const std::function<std::string(const std::string&)>& changed) const;

  bool empty() const { return m_text.empty(); }
  std::string english() const;

  enum class Kind { verbatim, fixed, rounded, pattern };
  Kind kind() const { return m_kind; }
  const std::string& text() const { return m_text; } ///< the pattern, or the text itself
  double number() const { return m_number; }
  int digits() const { return m_digits; } ///< behind the point, or those that count
  const std::vector<Message>& arguments() const { return m_arguments; }

  bool operator==(const Message&) const = default;

private:
  Kind m_kind = Kind::verbatim;
  std::string m_text;
  double m_number = 0.0;
  int m_digits = 0;
  std::vector<Message> m_arguments;
};

} // namespace limn
