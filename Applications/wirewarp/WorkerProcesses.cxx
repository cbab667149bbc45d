// SPDX-License-Identifier: BSD-3-Clause
#include "WorkerProcesses.h"

#ifndef _WIN32
#include "GuardedProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <list>
#include <stdexcept>
#include <string_view>
#include <vector>

#ifdef _WIN32
namespace wirewarp
{
// Processes cannot be copied there: one after the other in this one.
void runInProcesses(std::size_t count, std::size_t,
  const std::function<std::string(std::size_t)>& job,
  const std::function<void(std::size_t, const std::optional<std::string>&)>& done)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    done(k, job(k));
  }
}
}
#else
namespace wirewarp
{
namespace
{
using Job = std::function<std::string(std::size_t)>;

struct Worker
{
  pid_t process;
  int pipe;
  std::size_t job;
  std::string text; ///< as much as has come
};

[[noreturn]] void work(const Job& run, std::size_t job, int pipe)
{
  const std::string text = run(job);
  std::string_view rest = text;
  while (!rest.empty())
  {
    const ssize_t written = write(pipe, rest.data(), rest.size());
    if (written < 0 && errno != EINTR)
    {
      std::_Exit(EXIT_FAILURE);
    }
    rest.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  // What this process has inherited is not its own to tear down.
  std::_Exit(EXIT_SUCCESS);
}

bool start(const Job& run, std::size_t job, std::list<Worker>& workers)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return false;
  }
  fcntl(ends[1], F_SETFD, FD_CLOEXEC); // else a reader would hold it open
  std::cout.flush();
  std::fflush(stdout); // else the worker would write it as well
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process == 0)
  {
    dieWithParent(parent);
    work(run, job, ends[1]);
  }
  close(ends[1]);
  if (process < 0)
  {
    close(ends[0]);
    return false;
  }
  workers.push_back({ process, ends[0], job, "" });
  return true;
}

/// \return whether the worker goes on
bool receive(Worker& worker)
{
  char bytes[65536];
  const ssize_t received = read(worker.pipe, bytes, sizeof bytes);
  worker.text.append(bytes, received > 0 ? static_cast<std::size_t>(received) : 0);
  return received > 0 || (received < 0 && errno == EINTR);
}

/// \return its text, if it has not died
std::optional<std::string> ended(Worker& worker)
{
  close(worker.pipe);
  int status = EXIT_FAILURE;
  while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR)
  {
  }
  return status == EXIT_SUCCESS ? std::optional(worker.text) : std::nullopt;
}
}

void runInProcesses(std::size_t count, std::size_t workers, const Job& job,
  const std::function<void(std::size_t, const std::optional<std::string>&)>& done)
{
  std::list<Worker> running;
  std::size_t next = 0;
  while (next < count || !running.empty())
  {
    while (next < count && running.size() < workers && start(job, next, running))
    {
      ++next;
    }
    if (running.empty())
    {
      throw std::runtime_error(noProcess(errno));
    }
    std::vector<pollfd> pipes;
    for (const Worker& worker : running)
    {
      pipes.push_back({ worker.pipe, POLLIN, 0 });
    }
    if (poll(pipes.data(), pipes.size(), -1) < 0)
    {
      continue; // a signal
    }
    auto worker = running.begin();
    for (const pollfd& one : pipes)
    {
      if (one.revents == 0 || receive(*worker))
      {
        ++worker;
        continue;
      }
      const std::size_t k = worker->job;
      const std::optional<std::string> text = ended(*worker);
      worker = running.erase(worker);
      done(k, text);
    }
  }
}
}
#endif
