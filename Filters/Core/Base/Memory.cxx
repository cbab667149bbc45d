// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Memory.h"

#include <string>

namespace flattening
{
void throwOutOfMemory(std::size_t bytes)
{
  throw OutOfMemory(bytes);
}

Status outOfMemory(std::size_t bytes)
{
  const double gigabytes = 1e-9 * static_cast<double>(bytes);
  return { StatusCode::OutOfMemory,
    "memory ran out" +
      (bytes > 0 ? " (one factorization wants " + shortNumber(gigabytes) + " GB)" : std::string()),
    {}, { Remedy::FreeMemory } };
}

Status outOfThreads(const std::string& reason)
{
  return { StatusCode::OutOfMemory,
    "memory ran out, or the limit of threads was met (" + reason + ")", {},
    { { Remedy::Give, "a higher limit of processes (ulimit -u)" }, Remedy::FreeMemory } };
}
}
