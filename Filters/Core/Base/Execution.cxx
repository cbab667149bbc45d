// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Execution.h"

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

namespace flattening
{
Execution Execution::nestedExecution() const
{
  Execution inner;
  inner.factorMemory = this->factorMemory;
  inner.factorized = this->factorized;
  if (this->cancel)
  {
    // A caller may hold a lock while it waits for the loop; whoever asked it from another thread
    // would wait for that lock for ever.
    const auto told = std::make_shared<std::atomic<bool>>(false);
    inner.cancel = [ask = this->cancel, told, caller = std::this_thread::get_id()] {
      if (!*told && std::this_thread::get_id() == caller && ask())
      {
        *told = true;
      }
      return told->load();
    };
  }
  return inner;
}

void Execution::parallelFor(Index count, const std::function<void(Index, Index)>& body) const
{
  if (!this->parallel)
  {
    if (count > 0)
    {
      body(0, count);
    }
    return;
  }
  std::exception_ptr failure;
  std::mutex guard;
  this->parallel(count, [&](Index begin, Index end) {
    try
    {
      body(begin, end);
    }
    catch (...) // would end the program on a thread other than the caller's
    {
      const std::lock_guard<std::mutex> lock(guard);
      failure = std::current_exception();
    }
  });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
}
