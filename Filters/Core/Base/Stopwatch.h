// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace flattening
{
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
