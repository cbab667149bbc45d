// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace wirewarp
{
/// What a guarded process may use before it is ended.
struct ProcessLimits
{
  std::chrono::seconds cpu{ 10 };  ///< of its processor
  std::chrono::seconds wall{ 60 }; ///< of the clock
  std::size_t memory = 0;          ///< bytes beyond what it starts with; 0: as much as there is
};

enum class ProcessEnd
{
  Answered,
  Signal, ///< of its own making
  TooLong,
  Silent, ///< ended of itself, before its answer was whole
};

struct ProcessAnswer
{
  ProcessEnd end = ProcessEnd::Silent;
  int signal = 0;    ///< where one ended it
  std::string bytes; ///< as they came: a process that has gone astray may send anything
};

/// What to say where the system makes no process, by its errno, with the way out.
std::string noProcess(int error);

/// Runs a job in a process of its own, so that neither a crash nor an endless loop nor a hunger for
/// memory reaches this one. It is waited for, and dies with its parent. What it prints is lost.
/// \param job gives the answer and must not throw.
/// Throws std::runtime_error where no process can be made.
ProcessAnswer runGuarded(const ProcessLimits& limits, const std::function<std::string()>& job);
}
