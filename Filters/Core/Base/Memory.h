// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace flattening
{
/// What throwOutOfMemory() ends a run with where it is known how much is wanted; Core's entries
/// turn it, and every other std::bad_alloc, into StatusCode::OutOfMemory by withinMemory().
class OutOfMemory : public std::bad_alloc
{
public:
  explicit OutOfMemory(std::size_t bytes)
    : Bytes(bytes)
  {
  }
  std::size_t bytes() const { return this->Bytes; }
  const char* what() const noexcept override { return "out of memory"; }

private:
  std::size_t Bytes;
};

/// Thrown where no thread can be started, for want of memory or by another limit of the system.
class SystemLimit : public std::bad_alloc
{
public:
  /// \param reason as the system has it
  explicit SystemLimit(const char* reason)
    : Reason(reason) // NOLINT(bugprone-throw-keyword-missing): a member, for its text
  {
  }
  const char* what() const noexcept override { return this->Reason.what(); }

private:
  std::runtime_error Reason; ///< whose copies do not throw
};

/// Ends the run because this number of bytes is not there.
[[noreturn]] void throwOutOfMemory(std::size_t bytes);

/// The status of a run that ended by it. \param bytes that were wanted; 0: not known.
Status outOfMemory(std::size_t bytes);
/// The same where no thread could be started. \param reason as the system has it
Status outOfThreads(const std::string& reason);

/// The result of body(), or one with the status OutOfMemory alone; it may be a status itself.
template <typename Body>
auto withinMemory(const Body& body) -> decltype(body())
{
  decltype(body()) failed;
  const auto fail = [&failed](const Status& status) {
    if constexpr (std::is_same_v<decltype(body()), Status>)
    {
      failed = status;
    }
    else
    {
      failed.status = status;
    }
  };
  try
  {
    return body();
  }
  catch (const OutOfMemory& error)
  {
    fail(outOfMemory(error.bytes()));
  }
  catch (const SystemLimit& error)
  {
    fail(outOfThreads(error.what()));
  }
  catch (const std::bad_alloc&)
  {
    fail(outOfMemory(0));
  }
  catch (const std::length_error&) // more than a std::vector can ever hold
  {
    fail(outOfMemory(0));
  }
  return failed;
}
}
