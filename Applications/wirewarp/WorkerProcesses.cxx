// SPDX-License-Identifier: BSD-3-Clause
#include "WorkerProcesses.h"

#include "DieWithParent.h"
#include "GuardedProcess.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <list>
#include <stdexcept>
#include <vector>

namespace wirewarp
{
namespace
{
/// False at the end of the other side.
bool sendBytes(int socket, const void* data, std::size_t size)
{
  const char* next = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t sent = send(socket, next, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR)
    {
      continue;
    }
    if (sent <= 0)
    {
      return false;
    }
    next += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receiveBytes(int socket, void* data, std::size_t size)
{
  char* next = static_cast<char*>(data);
  while (size > 0)
  {
    const ssize_t received = recv(socket, next, size, 0);
    if (received < 0 && errno == EINTR)
    {
      continue;
    }
    if (received <= 0)
    {
      return false;
    }
    next += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

bool sendText(int socket, const std::string& text)
{
  const std::size_t size = text.size();
  return sendBytes(socket, &size, sizeof size) && sendBytes(socket, text.data(), size);
}

std::optional<std::string> receiveText(int socket)
{
  std::size_t size = 0;
  if (!receiveBytes(socket, &size, sizeof size))
  {
    return std::nullopt;
  }
  std::string text(size, '\0');
  return receiveBytes(socket, text.data(), size) ? std::optional(text) : std::nullopt;
}

struct Worker
{
  pid_t process = 0;
  int socket = -1;
  std::size_t job = 0;
};

class Pool
{
public:
  using Job = std::function<std::string(std::size_t)>;

  Pool(std::size_t count, const Job& job)
    : Count(count)
    , Run(job)
  {
  }
  ~Pool()
  {
    while (!this->Workers.empty())
    {
      this->end(this->Workers.begin());
    }
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// Keeps so many workers at work as long as there are jobs.
  void fill(std::size_t workers)
  {
    while (this->Next < this->Count && this->Workers.size() < workers)
    {
      if (!this->start())
      {
        if (this->Workers.empty())
        {
          throw std::runtime_error(noProcess(errno));
        }
        return;
      }
    }
  }

  bool busy() const { return !this->Workers.empty(); }

  /// Waits until a job ends.
  void wait(const std::function<void(std::size_t, const std::optional<std::string>&)>& done)
  {
    std::vector<pollfd> sockets;
    for (const Worker& worker : this->Workers)
    {
      sockets.push_back({ worker.socket, POLLIN, 0 });
    }
    if (poll(sockets.data(), sockets.size(), -1) < 0)
    {
      return; // a signal
    }
    auto worker = this->Workers.begin();
    for (const pollfd& socket : sockets)
    {
      const auto current = worker++;
      if (socket.revents == 0)
      {
        continue;
      }
      const std::size_t job = current->job;
      const std::optional<std::string> text = receiveText(current->socket);
      if (!text || !this->give(*current))
      {
        this->end(current);
      }
      done(job, text);
    }
  }

private:
  using Position = std::list<Worker>::iterator;

  /// The next job to a worker; false where there is none, or nobody to take it.
  bool give(Worker& worker)
  {
    if (this->Next >= this->Count || !sendBytes(worker.socket, &this->Next, sizeof this->Next))
    {
      return false;
    }
    worker.job = this->Next++;
    return true;
  }

  bool start()
  {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
    {
      return false;
    }
    std::cout.flush();
    std::fflush(stdout); // else the worker would write it as well
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process == 0)
    {
      dieWithParent(parent);
      close(ends[0]);
      for (const Worker& other : this->Workers)
      {
        close(other.socket);
      }
      this->work(ends[1]);
    }
    close(ends[1]);
    if (process < 0)
    {
      close(ends[0]);
      return false;
    }
    this->Workers.push_back({ process, ends[0], 0 });
    if (!this->give(this->Workers.back()))
    {
      this->end(std::prev(this->Workers.end()));
      return false;
    }
    return true;
  }

  [[noreturn]] void work(int socket) const
  {
    std::size_t job = 0;
    while (receiveBytes(socket, &job, sizeof job) && sendText(socket, this->Run(job)))
    {
    }
    // What this process has inherited is not its own to tear down.
    std::_Exit(EXIT_SUCCESS);
  }

  void end(Position worker)
  {
    close(worker->socket);
    while (waitpid(worker->process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
    this->Workers.erase(worker);
  }

  std::size_t Count;
  const Job& Run;
  std::size_t Next = 0;
  std::list<Worker> Workers;
};
}

void runInProcesses(std::size_t count, std::size_t workers,
  const std::function<std::string(std::size_t)>& job,
  const std::function<void(std::size_t, const std::optional<std::string>&)>& done)
{
  Pool pool(count, job);
  for (pool.fill(workers); pool.busy(); pool.fill(workers))
  {
    pool.wait(done);
  }
}
}
