// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Descriptor.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace limn {

/// The path of a program on the user's PATH; empty where it is not installed.
std::string findProgram(const std::string& name);

/// A program that runs beside this one, which writes to it and reads what it prints. It ends with its owner.
class ChildProcess {
public:
  /// Whether what it says of errors comes with what it prints, or waits for `errors`.
  enum class Errors { among, apart };

  /// Throws Error whose sentence is the system's reason alone, where the program cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               Errors errors);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  void write(std::string_view bytes); ///< what has ended hears nothing
  void closeInput() { m_input = Descriptor(); }

  /// What it prints next, at most so many milliseconds later (negative: however much), where nothing came by
  /// then an empty text; absent once it prints no more.
  std::optional<std::string> read(int mostMs);

  /// The next line without its end; absent once it prints no more.
  std::optional<std::string> readLine();

  /// Waits for the end; true where the program ended by itself and with success.
  bool succeeded();
  void kill();

  /// What it said of errors apart from what it printed.
  std::string errors() const;

private:
  pid_t m_id = 0; ///< 0 once it was waited for
  int m_status = 0;
  Descriptor m_input, m_output;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> m_errors;
  std::string m_read; ///< of what no line was given yet
};

} // namespace limn
