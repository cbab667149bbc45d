// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>

namespace wirewarp
{
inline constexpr const char* wayOutOfMemory =
  "close other programs, raise the limit of memory, or take a smaller surface";

/// An input that is refused. The text says what is wrong, where, and the remedy.
class InputError : public std::runtime_error
{
public:
  explicit InputError(const std::string& text)
    : std::runtime_error(text)
  {
  }
  InputError(const std::string& file, const std::string& text)
    : std::runtime_error(file + ": " + text)
  {
  }
  /// \param line counted from 1
  InputError(const std::string& file, std::size_t line, const std::string& text)
    : std::runtime_error(file + ":" + std::to_string(line) + ": " + text)
  {
  }
};

/// Runs a job that reads a file. \return why it failed; empty after success
template <typename Job>
std::string failureOf(const std::string& path, Job job)
{
  try
  {
    if (path.empty())
    {
      throw InputError("there is no file name; set FileName");
    }
    job();
    return {};
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  catch (const std::bad_alloc&)
  {
    return path + ": out of memory; " + wayOutOfMemory;
  }
  catch (const std::length_error&)
  {
    return path + ": out of memory; " + wayOutOfMemory;
  }
}
}
