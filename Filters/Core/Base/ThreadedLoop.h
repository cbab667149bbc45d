// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <functional>

namespace flattening
{
/// An Execution::parallel for callers without a pool of threads: threads of a loop live no longer
/// than it, so that a process can fork in between.
class ThreadedLoop
{
public:
  /// \param threads 0: as many as this process may run at a time; under a limit of memory one, since
  /// a thread for whose own data there is no memory ends the process in the C library
  explicit ThreadedLoop(unsigned int threads = 0);

  /// \param body that does not throw: Execution::parallelFor() catches what bodies throw
  void operator()(Index count, const std::function<void(Index, Index)>& body) const;

private:
  unsigned int Threads;
};
}
