// SPDX-License-Identifier: BSD-3-Clause
#include "FlagWords.h"

#include <vtkFlatteningAlgorithm.h>

#include <gtest/gtest.h>

#include <regex>

using wirewarp::messageOf;
using wirewarp::remedyWords;

TEST(FlagWords, EachRemedyHasWordsThatNameNoPropertyOfAFilter)
{
  ASSERT_GT(vtkFlatteningAlgorithm::GetNumberOfRemedies(), 30);
  const std::regex property("[A-Z][a-z]+[A-Z]|[A-Z]+_[A-Z]+");
  for (int k = 0; k < vtkFlatteningAlgorithm::GetNumberOfRemedies(); ++k)
  {
    const std::string name = vtkFlatteningAlgorithm::GetRemedyName(k);
    const std::string words = remedyWords(name);
    EXPECT_FALSE(words.empty()) << name;
    EXPECT_FALSE(std::regex_search(words, property)) << name << ": " << words;
  }
}

TEST(FlagWords, AnUnknownRemedyHasNone)
{
  EXPECT_EQ(remedyWords("Despair"), "");
}

TEST(FlagWords, AMessageIsTheDefectAndItsWaysOut)
{
  EXPECT_EQ(messageOf("it is broken", {}), "it is broken");
  EXPECT_EQ(messageOf("banks cross", { { "CloseCuts", "" }, { "Give", "a % sign" } }),
    "banks cross; close the cuts as far as they cross (--close-cuts), or give a % sign");
}
