// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/LargeArray.h"
#include "Base/Types.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace flattening
{
/// How a run talks to its caller: progress out, cancel in, and who runs loops in parallel.
/// The default reports nothing, is never cancelled and runs every loop on the calling thread.
struct Execution
{
  /// Called with a fraction in [0, 1] and the name of the phase, on the calling thread only.
  std::function<void(double, const char*)> progress;
  /// Called with lines that a search has found so far, whenever they change, on the calling thread
  /// only.
  std::function<void(const std::vector<Points3>&)> preview;
  /// Asked from time to time, on the calling thread only; true ends the run with
  /// StatusCode::Cancelled.
  std::function<bool()> cancel;
  /// Runs body(begin, end) over disjoint ranges that cover [0, count), in any order and on any
  /// thread. Bodies write to disjoint places only, so that results do not depend on it.
  std::function<void(Index count, const std::function<void(Index, Index)>& body)> parallel;
  /// Bytes that the factors of one linear system may take; more ends the run with
  /// StatusCode::OutOfMemory.
  std::size_t factorMemory = std::numeric_limits<std::size_t>::max();
  /// Where given, the factorizationWork() of each linear system that is factorized is added: what a
  /// run takes, counted alike on all machines and for any number of threads.
  std::atomic<std::int64_t>* factorized = nullptr;

  void report(double fraction, const char* phase) const
  {
    if (this->progress)
    {
      this->progress(fraction, phase);
    }
  }
  /// The same for a part of the run: its fractions of 0 to 1 are those from begin to end of the
  /// whole.
  Execution part(double begin, double end) const
  {
    Execution inner = *this;
    if (this->progress)
    {
      inner.progress = [outer = this->progress, begin, end](double fraction, const char* phase) {
        outer(begin + fraction * (end - begin), phase);
      };
    }
    return inner;
  }
  bool cancelled() const { return this->cancel && this->cancel(); }
  /// What the bodies of a parallel loop may hand on and ask: the calling thread asks the caller,
  /// the others hear what it was told. Reports nothing and runs loops on the thread that it is
  /// given to.
  Execution nestedExecution() const;
  /// The same for what is done after a run is cancelled; reports nothing.
  Execution uninterrupted() const
  {
    Execution inner = *this;
    inner.progress = nullptr;
    inner.preview = nullptr;
    inner.cancel = nullptr;
    return inner;
  }
  /// The same with loops on the thread that it is given to.
  Execution onOneThread() const
  {
    Execution inner = *this;
    inner.parallel = nullptr;
    return inner;
  }
  /// Of bodies that each take longer than to start a thread. What one throws comes out on the
  /// calling thread.
  void parallelFor(Index count, const std::function<void(Index, Index)>& body) const;
  /// The same with body(k) for each number below `count`.
  template <typename Body>
  void forEachTask(Index count, const Body& body) const
  {
    this->parallelFor(count, [&body](Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
      {
        body(k);
      }
    });
  }
  /// The same of bodies as short as the measures of a triangle: 64 of them are one task.
  template <typename Body>
  void forEach(Index count, const Body& body) const
  {
    constexpr Index together = 64;
    this->forEachTask((count + together - 1) / together, [&](Index group) {
      for (Index k = group * together; k < std::min(count, (group + 1) * together); ++k)
      {
        body(k);
      }
    });
  }
};

/// Calls compute(k), which gives a Result, on threads for each number below `count`, and
/// add(k, result) on the calling one in their order, so that sums do not depend on threads.
template <typename Result, typename Compute, typename Add>
void computeAndAdd(Index count, const Execution& execution, const Compute& compute, const Add& add)
{
  // Results at a time: few enough for the cache, and for threads so many that starting them counts
  // little.
  const Index together = execution.parallel ? 4096 : 64;
  LargeArray<Result> results(std::min(count, together));
  for (Index first = 0; first < count; first += together)
  {
    const Index here = std::min(together, count - first);
    execution.forEach(here, [&](Index k) { results[k] = compute(first + k); });
    for (Index k = 0; k < here; ++k)
    {
      add(first + k, results[k]);
    }
  }
}

/// Wall-clock seconds since it was made or last restarted.
class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }
  double restart()
  {
    const double elapsed = this->seconds();
    this->Start = std::chrono::steady_clock::now();
    return elapsed;
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
}
