// SPDX-License-Identifier: GPL-3.0-or-later
#include "Attempt.h"

#include "io/VolumeReader.h"
#include "scene/basics/Error.h"

#include <chrono>
#include <cstring>
#include <sstream>

#include <malloc.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limn::test {
namespace {

// What a child may map at most: a wrong reader must not bring down the machine. Sanitizers map terabytes.
constexpr rlim_t mostAddresses = rlim_t{6} << 30;

void limitMemory() {
  const rlimit limit{mostAddresses, mostAddresses};
  if (!isSanitised)
    setrlimit(RLIMIT_AS, &limit);
}

// What hangs comes to an end: by the time that it works, whatever else the machine does, or by the clock
// where it waits for something that never comes.
void limitTime(int seconds) {
  const auto limit = static_cast<rlim_t>(seconds);
  const rlimit processor{limit, limit + 1}; // at the second the kernel kills without saying why
  setrlimit(RLIMIT_CPU, &processor);
  alarm(10 * static_cast<unsigned>(seconds));
}

[[noreturn]] void runChild(const std::function<void(const std::function<void(const std::string&)>&)>& work,
                           int seconds, int out) {
  limitMemory();
  limitTime(seconds);
  work([out](const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t wrote = write(out, text.data() + done, text.size() - done);
      if (wrote <= 0)
        _exit(9);
      done += static_cast<std::size_t>(wrote);
    }
  });
  _exit(0);
}

std::string allFrom(int in) {
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = read(in, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(got));
  return text;
}

bool isGoodVoxels(const Volume& volume) {
  if (volume.grid().dims != glm::ivec3(2, 3, 4))
    return false;
  for (int i = 0; i < 24; ++i)
    if (volume.value({i % 2, i / 2 % 3, i / 6}) != i)
      return false;
  return true;
}

// One fact a line; what a line cannot hold becomes a question mark.
std::string line(char key, std::string text) {
  for (char& c : text)
    c = c == '\n' ? '\1' : c;
  std::string result(1, key);
  return result.append(text).append(1, '\n');
}

void read(const std::filesystem::path& path, const std::function<void(const std::string&)>& say) {
  try {
    const auto volume = readVolume(path);
    const glm::ivec3 dims = volume->grid().dims;
    const std::size_t bytes =
        std::visit([](const auto& voxels) { return voxels.size() * sizeof(voxels[0]); }, volume->stored());
    std::ostringstream facts;
    facts << 'V' << dims.x << ' ' << dims.y << ' ' << dims.z << ' ' << isGoodVoxels(*volume) << ' ' << bytes
          << '\n';
    say(facts.str());
    for (const Message& warning : volume->info().warnings)
      say(line('W', warning.english()));
  } catch (const Error& error) {
    say(line(error.kind() == Error::Kind::input ? 'R' : 'X', error.what()));
  } catch (const std::exception& error) {
    say(line('X', error.what()));
  }
  say("E\n");
}

std::string howStopped(int signal, int seconds) {
  if (signal == SIGXCPU)
    return "took longer than " + std::to_string(seconds) + " s";
  if (signal == SIGALRM)
    return "waited longer than " + std::to_string(10 * seconds) + " s";
  return "killed by signal " + std::to_string(signal);
}

} // namespace

ChildEnd inChild(const std::function<void(const std::function<void(const std::string&)>& say)>& work,
                 int seconds) {
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("cannot make a pipe");
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("cannot make a process");
  if (child == 0) {
    close(ends[0]);
    runChild(work, seconds, ends[1]);
  }
  close(ends[1]);
  ChildEnd end;
  end.said = allFrom(ends[0]);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  end.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  end.peakBytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  end.isWell = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (WIFSIGNALED(status))
    end.how = howStopped(WTERMSIG(status), seconds);
  else if (!end.isWell)
    end.how = "ended with status " + std::to_string(WEXITSTATUS(status));
  return end;
}

Attempt attempt(const std::filesystem::path& path) {
  const ChildEnd end = inChild([&](const auto& say) { read(path, say); });
  Attempt result;
  result.seconds = end.seconds;
  result.peakBytes = end.peakBytes;
  result.trouble = end.how;
  std::istringstream lines(end.said);
  for (std::string text; std::getline(lines, text);) {
    const std::string rest = text.substr(1);
    if (text[0] == 'V') {
      result.isVolume = true;
      std::istringstream(rest) >> result.dims.x >> result.dims.y >> result.dims.z >> result.hasGoodVoxels >>
          result.decodedBytes;
    } else if (text[0] == 'W') {
      result.warnings.push_back(rest);
    } else if (text[0] == 'R') {
      result.refusal = rest;
    } else if (text[0] == 'X') {
      result.trouble = "stray exception: " + rest;
    } else if (text[0] == 'E') {
      result.isWell = end.isWell && result.trouble.empty();
    }
  }
  return result;
}

bool isOneSentence(const std::string& text) {
  constexpr std::size_t longest = 700;
  if (text.empty() || text.back() != '.' || text.size() > longest)
    return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((text[i] >= 0 && text[i] < ' ') || text[i] == 0x7f)
      return false;
    if (i + 2 < text.size() && std::strchr(".!?", text[i]) && text[i + 1] == ' ' && text[i + 2] >= 'A' &&
        text[i + 2] <= 'Z')
      return false;
  }
  return true;
}

} // namespace limn::test
