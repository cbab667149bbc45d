// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Base/ThreadedLoop.h"

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace wirewarp
{
namespace
{
constexpr std::chrono::milliseconds terminalPeriod(200);
constexpr std::chrono::seconds logPeriod(10);

volatile std::sig_atomic_t interrupted = 0;
}

bool stderrIsTerminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) == 1;
#endif
}

Progress::Progress(bool quiet)
  : Quiet(quiet)
  , Terminal(stderrIsTerminal())
  , Next(this->Begin + (this->Terminal ? std::chrono::seconds(1) : logPeriod))
{
}

Progress::~Progress()
{
  if (this->Shown && this->Terminal)
  {
    std::fputs("\r\033[K", stderr);
  }
}

flattening::Execution Progress::execution(int threads)
{
  flattening::Execution execution;
  if (!this->Quiet)
  {
    execution.progress = [this](
                           double fraction, const char* phase) { this->show(fraction, phase); };
  }
  execution.parallel = flattening::ThreadedLoop(static_cast<unsigned int>(threads));
  return execution;
}

void Progress::show(double fraction, const char* phase)
{
  const Clock::time_point now = Clock::now();
  if (now < this->Next)
  {
    return;
  }
  this->Next =
    now + (this->Terminal ? Clock::duration(terminalPeriod) : Clock::duration(logPeriod));
  this->Shown = true;
  const double percent = 100.0 * std::clamp(fraction, 0.0, 1.0);
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

Interruption::Interruption()
{
  interrupted = 0;
  this->Before = std::signal(SIGINT, [](int) {
    interrupted = 1;
    std::signal(SIGINT, SIG_DFL);
  });
  if (this->Before == SIG_IGN)
  {
    std::signal(SIGINT, SIG_IGN);
  }
}

Interruption::~Interruption()
{
  std::signal(SIGINT, this->Before);
}

bool Interruption::pressed()
{
  return interrupted != 0;
}

void Interruption::forget()
{
  interrupted = 0;
}
}
