// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Execution.h"

#include <exception>
#include <mutex>

namespace flattening
{
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
