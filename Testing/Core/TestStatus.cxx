// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Status.h"

#include <gtest/gtest.h>

#include <cfenv>

using namespace flattening;

TEST(Status, AListOfIdsIsCutWhereItGetsLongAndSaysHowManyAreLeft)
{
  EXPECT_EQ(listIds(Indices{}, 3), "");
  EXPECT_EQ(listIds(Indices{ 4, 7 }, 3), "4, 7");
  EXPECT_EQ(listIds(Indices{ 4, 7, 9, 11, 12 }, 3), "4, 7, 9 and 2 more");
}

TEST(FloatingPointTraps, AreOnInThisProgram)
{
  const int wanted = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  EXPECT_EQ(fegetexcept() & wanted, wanted);
}
