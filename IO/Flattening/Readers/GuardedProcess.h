// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

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
  int exitCode = 0;  ///< where it ended of itself; 127: its libraries could not be loaded
  std::string bytes; ///< as they came: a process that has gone astray may send anything
};

/// Message for a process that the system could not start, by its errno, with a remedy.
std::string noProcess(int error);

/// Ends the calling process, a child, as soon as its parent has ended, even by SIGKILL. Where the
/// system knows no such thing, it ends when it next reads from or writes to its parent.
/// \param parent its id, taken before the fork
void dieWithParent(int parent);

/// Runs a program that calls answerGuarded(), so that neither a crash nor an endless loop nor a
/// hunger for memory reaches this one. It is waited for, and dies with its parent. What it prints
/// is lost. A program of its own, and not a copy of this process: in a process of many threads a
/// copy may wait forever for a lock that no thread of it will release.
/// \param program a path, or a name in PATH
/// Throws std::runtime_error where no process can be made.
ProcessAnswer runGuarded(const ProcessLimits& limits, const std::string& program,
  const std::vector<std::string>& arguments);

/// The path of a program that is installed for the use of this one.
std::string helperProgram(const std::string& name);

/// All that main() of such a program does: answers its parent within the limits that this states.
/// \param job gets the arguments; it gives the answer and must not throw
int answerGuarded(
  int argc, char** argv, const std::function<std::string(const std::vector<std::string>&)>& job);
}
