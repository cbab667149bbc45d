// SPDX-License-Identifier: BSD-3-Clause
#include "DieWithParent.h"

#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>

#include <csignal>
#endif

#include <cstdlib>

namespace wirewarp
{
void dieWithParent(int parent)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (getppid() != parent) // it was faster
  {
    std::_Exit(EXIT_FAILURE);
  }
}
}
