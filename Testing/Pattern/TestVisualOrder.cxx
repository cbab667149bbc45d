// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternWriters.h"

#include <gtest/gtest.h>

TEST(VisualOrder, IsThatOfTheUnicodeRules)
{
  struct Case
  {
    const char* rule;
    const char* text;
    const char* shown;
  };
  for (const auto& [rule, text, shown] :
    { Case{ "letters from the left stay as they are", "", "" },
      Case{ "letters from the left stay as they are", "Ärmel (links), 2 x", "Ärmel (links), 2 x" },
      Case{ "a Hebrew name runs from the right", "שלום", "םולש" },
      Case{ "a Hebrew name runs from the right", "שרוול ימין", "ןימי לוורש" },
      Case{ "numbers in Hebrew run from the left", "מידה 38.5", "38.5 הדימ" },
      Case{ "numbers in Hebrew run from the left", "גב 12 שמאל", "לאמש 12 בג" },
      Case{ "a Hebrew word in a line from the left turns round alone", "to שרוול 2, end",
        "to 2 לוורש, end" },
      Case{ "a Hebrew word in a line from the left turns round alone", "1: שרוול 38, cut 1",
        "1: 38 לוורש, cut 1" },
      Case{ "a Hebrew word in a line from the left turns round alone", "1: שרוול", "לוורש :1" },
      Case{ "brackets open towards what they hold", "גב (שמאל)", "(לאמש) בג" },
      Case{ "marks stay behind their letters", "\u05E9\u05C1\u05D0", "\u05D0\u05E9\u05C1" },
      Case{ "signs of measure stay on their side of the number", "מידה 50%", "50% הדימ" },
      Case{ "signs of measure stay on their side of the number", "ימין 20°", "20° ןימי" },
      Case{ "brackets in a line from the left hold their word", "(שמאל) 2 x", "(לאמש) 2 x" },
      Case{ "marks of direction are heeded and not drawn", "a \u05D1!\u200F c", "a !\u05D1 c" },
      Case{ "Arabic letters join: seen at the start, lam with alef, meem alone",
        "\u0633\u0644\u0627\u0645", "\uFEE1\uFEFC\uFEB3" },
      Case{ "characters beyond sixteen bits stay whole", "\U0001F600 \u05D0\u05D1",
        "\u05D1\u05D0 \U0001F600" } })
  {
    EXPECT_EQ(flattening::pattern::visualOrder(text), shown) << rule;
  }
}
