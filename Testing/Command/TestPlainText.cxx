// SPDX-License-Identifier: BSD-3-Clause
#include "PlainText.h"

#include <gtest/gtest.h>

namespace
{
using namespace std::string_view_literals;
using wirewarp::plainText;

TEST(PlainText, WordsOfAnyLanguageStayAsTheyAre)
{
  for (const char* text :
    { "", "waist 2/3", "\u00E4rmel", "\u8896", "\U0001F455", "\u00A0", "\uFFFD" })
  {
    EXPECT_EQ(plainText(text), text);
  }
}

TEST(PlainText, ControlCharactersBecomeQuestionMarks)
{
  EXPECT_EQ(plainText("a\x1B[31m"), "a?[31m");
  EXPECT_EQ(plainText("\0\n\r\t\x7F"sv), "?????");
  EXPECT_EQ(plainText("\xC2\x9B[m"), "?[m"); // an escape sequence of eight bits
  EXPECT_EQ(plainText("\u202E"), "?");       // turns the direction of writing
  EXPECT_EQ(plainText("\u2028"), "?");       // ends a line
}

TEST(PlainText, EachByteThatIsNoUtf8BecomesAQuestionMark)
{
  EXPECT_EQ(plainText("caf\xE9.obj"), "caf?.obj");
  EXPECT_EQ(plainText("\x9B[m"), "?[m");
  EXPECT_EQ(plainText("\xE2\x80"), "??");
  EXPECT_EQ(plainText("\xC3\x1B"), "??");
  EXPECT_EQ(plainText("\xC0\x9B"), "??");           // an escape in more bytes than it needs
  EXPECT_EQ(plainText("\xED\xA0\x80"), "???");      // a half of a pair
  EXPECT_EQ(plainText("\xF4\x90\x80\x80"), "????"); // beyond Unicode
}

TEST(PlainText, NothingIsLeftThatXmlForbids)
{
  EXPECT_EQ(plainText("\uFFFE \uFFFF"), "? ?");
}
}
