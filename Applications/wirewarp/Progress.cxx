// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace wirewarp
{
namespace
{
constexpr std::chrono::milliseconds terminalPeriod(200);
constexpr std::chrono::seconds logPeriod(10);
}

Progress::Progress(vtkAlgorithm* filter, bool quiet)
  : Filter(filter)
  , Terminal(isatty(STDERR_FILENO) == 1)
  , Next(this->Begin + (this->Terminal ? std::chrono::seconds(1) : logPeriod))
{
  if (!quiet)
  {
    this->Observer = filter->AddObserver(vtkCommand::ProgressEvent, this, &Progress::show);
  }
}

Progress::~Progress()
{
  this->Filter->RemoveObserver(this->Observer);
  if (this->Shown && this->Terminal)
  {
    std::fputs("\r\033[K", stderr);
  }
}

void Progress::show()
{
  const Clock::time_point now = Clock::now();
  if (now < this->Next)
  {
    return;
  }
  this->Next =
    now + (this->Terminal ? Clock::duration(terminalPeriod) : Clock::duration(logPeriod));
  this->Shown = true;
  const double percent = 100.0 * std::clamp(this->Filter->GetProgress(), 0.0, 1.0);
  const char* const phase = this->Filter->GetProgressText();
  const double seconds = std::chrono::duration<double>(now - this->Begin).count();
  constexpr double fewPercent = 5.0; // from which the rest is estimated
  char left[48] = "";
  if (percent >= fewPercent && percent < 100.0)
  {
    std::snprintf(left, sizeof left, ", about %.0f s left", seconds * (100.0 - percent) / percent);
  }
  std::fprintf(stderr, this->Terminal ? "\r\033[K%3.0f %% %s, %.0f s%s" : "%3.0f %% %s, %.0f s%s\n",
    percent, phase ? phase : "", seconds, left);
  std::fflush(stderr);
}
}
