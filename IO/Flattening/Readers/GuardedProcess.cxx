// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedProcess.h"

#include "TextFile.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <system_error>

extern char** environ; // POSIX declares it in no header

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;

/// Addresses in use, 0 where the system does not tell.
std::size_t addressSpace()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t value)
{
  rlimit bounds{};
  if (getrlimit(resource, &bounds) == 0)
  {
    bounds.rlim_cur = std::min(value, bounds.rlim_max);
    setrlimit(resource, &bounds);
  }
}

void applyLimits(const ProcessLimits& limits)
{
  limit(RLIMIT_CORE, 0); // its crash is expected and told in a message
  limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu.count()));
  const std::size_t base = addressSpace();
  if (limits.memory > 0 && base > 0)
  {
    limit(RLIMIT_AS, base + limits.memory);
  }
}

/// What libraries print on their way down must not mix with the command's own lines.
void closeStandardStreams()
{
  const int nothing = open("/dev/null", O_RDWR);
  for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    dup2(nothing, stream);
  }
  if (nothing > STDERR_FILENO)
  {
    close(nothing);
  }
}

void writeAll(int file, const char* data, std::size_t size)
{
  while (size > 0)
  {
    const ssize_t written = write(file, data, size);
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      return;
    }
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

/// The parent's hold on its child: no way out of it leaves a zombie.
class Child
{
public:
  Child(const ProcessLimits& limits, const std::string& program,
    const std::vector<std::string>& arguments)
  {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
    {
      throw std::runtime_error(noProcess(errno));
    }
    this->Answer = ends[0];
    for (const int end : ends)
    {
      fcntl(end, F_SETFD, FD_CLOEXEC);
    }
    std::vector<std::string> words{ program, std::to_string(getpid()),
      std::to_string(limits.cpu.count()), std::to_string(limits.memory) };
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
    {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_adddup2(&streams, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDWR, 0);
    posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, "/dev/null", O_RDWR, 0);
    const int error =
      posix_spawnp(&this->Process, program.c_str(), &streams, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&streams);
    close(ends[1]);
    if (error != 0)
    {
      close(this->Answer);
      throw std::runtime_error(error == ENOENT
          ? program + " is not there; install it with the program"
          : noProcess(error));
    }
  }
  ~Child()
  {
    close(this->Answer);
    if (this->Process > 0)
    {
      kill(this->Process, SIGKILL);
      this->wait();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Appends what comes until the other side is closed. \return false at the deadline
  bool receive(std::string& bytes, Clock::time_point deadline) const
  {
    std::vector<char> block(std::size_t(1) << 18);
    for (;;)
    {
      const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
      if (left <= 0)
      {
        return false;
      }
      pollfd waiting{ this->Answer, POLLIN, 0 };
      if (poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 60000))) <= 0)
      {
        continue; // time passed, or a signal
      }
      const ssize_t received = read(this->Answer, block.data(), block.size());
      if (received == 0)
      {
        return true;
      }
      if (received > 0)
      {
        bytes.append(block.data(), static_cast<std::size_t>(received));
      }
    }
  }

  /// \return as waitpid() tells it
  int wait()
  {
    int status = 0;
    while (waitpid(this->Process, &status, 0) < 0 && errno == EINTR)
    {
    }
    this->Process = 0;
    return status;
  }

private:
  int Answer = -1;
  pid_t Process = 0;
};

/// Takes the length off the end of an answer. \return false where it is another
bool unframe(std::string& bytes)
{
  std::uint64_t size = 0;
  if (bytes.size() < sizeof size)
  {
    return false;
  }
  const std::size_t length = bytes.size() - sizeof size;
  std::memcpy(&size, bytes.data() + length, sizeof size);
  bytes.resize(length);
  return bytes.size() == size;
}
}

void dieWithParent(int parent)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent) // it was faster
  {
    std::_Exit(EXIT_FAILURE);
  }
}

std::string noProcess(int error)
{
  return "cannot make a process " + systemReason(error, "close other programs");
}

ProcessAnswer runGuarded(const ProcessLimits& limits, const std::string& program,
  const std::vector<std::string>& arguments)
{
  ProcessAnswer answer;
  Child child(limits, program, arguments);
  if (!child.receive(answer.bytes, Clock::now() + limits.wall))
  {
    answer.end = ProcessEnd::TooLong;
    return answer;
  }
  const int status = child.wait();
  if (WIFSIGNALED(status))
  {
    answer.signal = WTERMSIG(status);
    answer.end = answer.signal == SIGXCPU ? ProcessEnd::TooLong : ProcessEnd::Signal;
  }
  else if (unframe(answer.bytes))
  {
    answer.end = ProcessEnd::Answered;
  }
  answer.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  return answer;
}

std::string helperProgram(const std::string& name)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (error)
  {
    return name; // PATH is left
  }
  const fs::path beside = folder / name; // in a build tree
  return fs::exists(beside, error) ? beside.string()
                                   : (folder / FLATTENING_HELPERS / name).string();
}

int answerGuarded(
  int argc, char** argv, const std::function<std::string(const std::vector<std::string>&)>& job)
{
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  std::array<long long, 3> numbers{}; // as Child gives them
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    if (k >= words.size() || !parseInteger(words[k], numbers[k]) || numbers[k] < 0)
    {
      std::cerr << "This program is run by wirewarp and PatternEditor.\n";
      return EXIT_FAILURE;
    }
  }
  dieWithParent(static_cast<int>(numbers[0]));
  const int answer = dup(STDOUT_FILENO);
  closeStandardStreams();
  std::signal(SIGXCPU, SIG_DFL);
  ProcessLimits limits;
  limits.cpu = std::chrono::seconds(numbers[1]);
  limits.memory = static_cast<std::size_t>(numbers[2]);
  applyLimits(limits);
  const std::string bytes = job({ words.begin() + numbers.size(), words.end() });
  const std::uint64_t size = bytes.size();
  writeAll(answer, bytes.data(), bytes.size());
  writeAll(answer, reinterpret_cast<const char*>(&size), sizeof size);
  std::_Exit(EXIT_SUCCESS); // whatever a damaged file has left to tear down
}
}
