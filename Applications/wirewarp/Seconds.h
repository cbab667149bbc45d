// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace wirewarp
{
/// Of the wall clock.
inline double secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}
