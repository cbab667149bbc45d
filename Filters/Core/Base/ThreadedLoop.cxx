// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ThreadedLoop.h"

#ifdef __linux__
#include <sched.h>
#endif
#ifndef _WIN32
#include <sys/resource.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <system_error>
#include <thread>
#include <vector>

namespace flattening
{
namespace
{
unsigned int usableThreads()
{
#ifndef _WIN32
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) != 0 || memory.rlim_cur != RLIM_INFINITY)
  {
    return 1;
  }
#endif
#ifdef __linux__
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0)
  {
    return static_cast<unsigned int>(CPU_COUNT(&allowed));
  }
#endif
  return std::max(1u, std::thread::hardware_concurrency());
}
}

ThreadedLoop::ThreadedLoop(unsigned int threads)
  : Threads(threads > 0 ? threads : usableThreads())
{
}

void ThreadedLoop::operator()(Index count, const std::function<void(Index, Index)>& body) const
{
  const Index ranges = std::min<Index>(static_cast<Index>(4 * this->Threads), count);
  if (ranges < 2 || this->Threads < 2)
  {
    body(0, count);
    return;
  }
  std::atomic<Index> next{ 0 };
  const auto work = [&] {
    for (Index k = next++; k < ranges; k = next++)
    {
      const auto at = [&](Index range) {
        return static_cast<Index>(std::int64_t{ count } * range / ranges);
      };
      body(at(k), at(k + 1));
    }
  };
  std::vector<std::thread> threads;
  try
  {
    threads.reserve(this->Threads);
    while (threads.size() + 1 < this->Threads)
    {
      threads.emplace_back(work);
    }
  }
  catch (const std::system_error&) // the system has no more: those that run do all
  {
  }
  work();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
}
