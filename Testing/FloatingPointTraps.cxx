// SPDX-License-Identifier: BSD-3-Clause
// Linked into the tests of numbers: from the start of the program an invalid operation, a division
// by zero or an overflow ends it with SIGFPE, so that a NaN is caught where it is born.
#include <cfenv>

namespace
{
struct FloatingPointTraps
{
  FloatingPointTraps() { feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW); }
};

const FloatingPointTraps traps;
}
