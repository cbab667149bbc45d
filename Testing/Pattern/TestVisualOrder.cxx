// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/VisualOrder.h"

#include <gtest/gtest.h>

namespace
{
using flattening::pattern::visualOrder;

TEST(VisualOrder, LettersFromTheLeftStayAsTheyAre)
{
  EXPECT_EQ(visualOrder(""), "");
  EXPECT_EQ(visualOrder("Ärmel (links), 2 x"), "Ärmel (links), 2 x");
}

TEST(VisualOrder, AHebrewNameRunsFromTheRight)
{
  EXPECT_EQ(visualOrder("שלום"), "םולש");
  EXPECT_EQ(visualOrder("שרוול ימין"), "ןימי לוורש");
}

TEST(VisualOrder, NumbersInHebrewRunFromTheLeft)
{
  EXPECT_EQ(visualOrder("מידה 38.5"), "38.5 הדימ");
  EXPECT_EQ(visualOrder("גב 12 שמאל"), "לאמש 12 בג");
}

TEST(VisualOrder, AHebrewWordInALineFromTheLeftTurnsRoundAlone)
{
  EXPECT_EQ(visualOrder("to שרוול 2, end"), "to 2 לוורש, end");
  EXPECT_EQ(visualOrder("1: שרוול 38, cut 1"), "1: 38 לוורש, cut 1");
  EXPECT_EQ(visualOrder("1: שרוול"), "לוורש :1"); // nothing in it runs from the left
}

TEST(VisualOrder, BracketsOpenTowardsWhatTheyHold)
{
  EXPECT_EQ(visualOrder("גב (שמאל)"), "(לאמש) בג");
}

TEST(VisualOrder, MarksStayBehindTheirLetters)
{
  EXPECT_EQ(visualOrder("\u05E9\u05C1\u05D0"), "\u05D0\u05E9\u05C1");
}

TEST(VisualOrder, SignsOfMeasureStayOnTheirSideOfTheNumber)
{
  EXPECT_EQ(visualOrder("מידה 50%"), "50% הדימ");
  EXPECT_EQ(visualOrder("ימין 20°"), "20° ןימי");
}

TEST(VisualOrder, BracketsInALineFromTheLeftHoldTheirWord)
{
  EXPECT_EQ(visualOrder("(שמאל) 2 x"), "(לאמש) 2 x");
}

TEST(VisualOrder, MarksOfDirectionAreHeededAndNotDrawn)
{
  EXPECT_EQ(visualOrder("a \u05D1!\u200F c"), "a !\u05D1 c");
}

TEST(VisualOrder, ArabicLettersJoin)
{
  // seen at the start, lam with alef as one at the end, meem alone
  EXPECT_EQ(visualOrder("\u0633\u0644\u0627\u0645"), "\uFEE1\uFEFC\uFEB3");
}

TEST(VisualOrder, CharactersBeyondSixteenBitsStayWhole)
{
  EXPECT_EQ(visualOrder("\U0001F600 \u05D0\u05D1"), "\u05D1\u05D0 \U0001F600");
}
}
