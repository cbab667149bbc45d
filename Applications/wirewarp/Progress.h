// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <chrono>

namespace wirewarp
{
/// Shows on stderr, while it lives, how far a filter has come: on a terminal as one line that
/// renews itself, else as a line every ten seconds. Short runs show nothing.
class Progress
{
public:
  Progress(vtkAlgorithm* filter, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  void show();

  vtkAlgorithm* Filter;
  unsigned long Observer = 0;
  bool Terminal;
  bool Shown = false;
  Clock::time_point Begin = Clock::now();
  Clock::time_point Next;
};

/// Of the wall clock.
inline double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}
