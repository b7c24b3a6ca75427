// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/ChildProcess.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn {
namespace {

[[noreturn]] void fail(int reason) {
  throw Error(Error::Kind::other, std::generic_category().message(reason));
}

} // namespace

std::string findProgram(const std::string& name) {
  const char* folders = std::getenv("PATH");
  std::istringstream path(folders ? folders : "");
  for (std::string folder; std::getline(path, folder, ':');) {
    const std::filesystem::path candidate = std::filesystem::path(folder) / name;
    std::error_code unknown;
    if (!folder.empty() && std::filesystem::is_regular_file(candidate, unknown) &&
        access(candidate.c_str(), X_OK) == 0)
      return candidate.string();
  }
  return {};
}

ChildProcess::ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                           Errors errors)
    : m_errors(errors == Errors::apart ? std::tmpfile() : nullptr, std::fclose) {
  int input[2], output[2];
  if (pipe2(input, O_CLOEXEC) != 0)
    fail(errno);
  m_input = Descriptor(input[1]);
  const Descriptor itsInput(input[0]);
  if (pipe2(output, O_CLOEXEC) != 0)
    fail(errno);
  m_output = Descriptor(output[0]);
  const Descriptor itsOutput(output[1]);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, itsInput.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, itsOutput.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, m_errors ? fileno(m_errors.get()) : itsOutput.number(),
                                   STDERR_FILENO);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int failure = posix_spawnp(&m_id, pointers.front(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == 0)
    return;
  m_id = 0;
  fail(failure);
}

ChildProcess::~ChildProcess() {
  kill();
  succeeded();
}

// The signal of a pipe that nobody reads is taken back: it would end this program.
void ChildProcess::write(std::string_view bytes) {
  sigset_t broken, before;
  sigemptyset(&broken);
  sigaddset(&broken, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &broken, &before);
  while (!bytes.empty()) {
    const ssize_t written = ::write(m_input.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0) {
      const timespec atOnce{};
      sigtimedwait(&broken, nullptr, &atOnce);
      break;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

std::optional<std::string> ChildProcess::read(int mostMs) {
  if (!m_read.empty())
    return std::exchange(m_read, {});
  pollfd output{m_output.number(), POLLIN, 0};
  if (poll(&output, 1, mostMs) <= 0)
    return std::string();
  char bytes[4096];
  const ssize_t count = ::read(m_output.number(), bytes, sizeof bytes);
  if (count > 0)
    return std::string(bytes, static_cast<std::size_t>(count));
  return count < 0 && errno == EINTR ? std::optional(std::string()) : std::nullopt;
}

std::optional<std::string> ChildProcess::readLine() {
  std::string text;
  for (;;) {
    if (const auto end = text.find('\n'); end != std::string::npos) {
      m_read = text.substr(end + 1);
      return text.substr(0, end);
    }
    const auto more = read(-1);
    if (!more)
      return text.empty() ? std::nullopt : std::optional(text);
    text += *more;
  }
}

bool ChildProcess::succeeded() {
  while (m_id != 0)
    if (waitpid(m_id, &m_status, 0) == m_id || errno != EINTR)
      m_id = 0;
  return WIFEXITED(m_status) && WEXITSTATUS(m_status) == 0;
}

void ChildProcess::kill() {
  if (m_id != 0)
    ::kill(m_id, SIGKILL);
}

std::string ChildProcess::errors() const {
  std::string said;
  if (!m_errors)
    return said;
  std::rewind(m_errors.get());
  for (int letter = 0; (letter = std::fgetc(m_errors.get())) != EOF;)
    said += static_cast<char>(letter);
  return said;
}

} // namespace limn
