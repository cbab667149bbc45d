// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"

#include <chrono>

namespace wirewarp
{
bool stderrIsTerminal();

/// Shows on stderr, while it lives, how far a run has come: on a terminal as one line that renews
/// itself, else as a line every ten seconds. Short runs show nothing.
class Progress
{
public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A run that is shown. \param threads 0: as many as there are cores
  flattening::Execution execution(int threads);

private:
  using Clock = std::chrono::steady_clock;
  void show(double fraction, const char* phase);

  bool Quiet;
  bool Terminal;
  bool Shown = false;
  Clock::time_point Begin = Clock::now();
  Clock::time_point Next;
};

/// While it lives, Ctrl+C ends a search, and pressed once more the program.
class Interruption
{
public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool pressed();
  static void forget();

private:
  void (*Before)(int);
};

/// Of the wall clock.
inline double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}
