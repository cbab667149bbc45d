// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/PatternText.h"

#include "Drawing/PatternStrokes.h"

#include <gtest/gtest.h>

using namespace flattening::pattern;

TEST(PatternText, KeepsValidTextAndReplacesBrokenBytes)
{
  EXPECT_EQ(cleanText("Gr\xC3\xB6\xC3\x9F"
                      "e \xE8\xA3\xA4 \xF0\x9D\x94\x98"),
    "Gr\xC3\xB6\xC3\x9F"
    "e \xE8\xA3\xA4 \xF0\x9D\x94\x98");
  EXPECT_EQ(cleanText("a\xFFz"), "a\xEF\xBF\xBDz");
  EXPECT_EQ(cleanText("\xC3"), "\xEF\xBF\xBD");
  EXPECT_EQ(cleanText("\xC0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "overlong";
  EXPECT_EQ(cleanText("\xED\xA0\x80").find('\xED'), std::string::npos) << "surrogate";
  EXPECT_EQ(cleanText(std::string("a\0b\n\x7F"
                                  "c",
              6)),
    "a b  c");
}

TEST(PatternText, WritesNumbersWithoutExponentsAndTrailingZeros)
{
  EXPECT_EQ(formatNumber(1.5, 9), "1.5");
  EXPECT_EQ(formatNumber(-0.0, 9), "0");
  EXPECT_EQ(formatNumber(-1e-12, 9), "0");
  EXPECT_EQ(formatNumber(100.0, 3), "100");
  EXPECT_EQ(formatNumber(1e15, 3), "1000000000000000");
  EXPECT_EQ(formatNumber(1.0 / 3.0, 4), "0.3333");
}

TEST(PatternText, CutsLongTextsBetweenCharacters)
{
  EXPECT_EQ(fitText("short", 3.0, 100.0), "short");
  const std::string umlauts = "\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4";
  const std::string cut = fitText(umlauts, 3.0, textWidth("123456", 3.0) + 1e-9);
  EXPECT_EQ(cut, "\xC3\xA4\xC3\xA4\xC3\xA4...");
  EXPECT_EQ(fitText("no room", 3.0, 0.0), "...");
}

TEST(PatternText, CutsATextInTimeThatGrowsWithItsLengthAlone)
{
  const std::string letters(3000000, 'n'); // their square would take hours
  const std::string cut = fitText(letters, 3.0, textWidth(letters, 3.0) / 2.0);
  EXPECT_NEAR(static_cast<double>(cut.size()), 1500000.0, 1.0);
}
