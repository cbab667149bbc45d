// SPDX-License-Identifier: BSD-3-Clause
#include "FlagWords.h"

#include <vtkFlatteningAlgorithm.h>

#include <gtest/gtest.h>

#include <cstdio>

#include <memory>
#include <regex>
#include <set>

using wirewarp::messageOf;
using wirewarp::remedyWords;

namespace
{
/// What the help of all commands lists.
std::set<std::string> flagsOfTheCommand()
{
  std::string text;
  for (const char* const help : { WIREWARP " --help", WIREWARP " flatten --help-all",
         WIREWARP " pattern --help-all", WIREWARP " sew --help-all" })
  {
    const std::unique_ptr<FILE, int (*)(FILE*)> output(popen(help, "r"), pclose);
    for (int c = std::fgetc(output.get()); c != EOF; c = std::fgetc(output.get()))
    {
      text += static_cast<char>(c);
    }
  }
  const std::regex flag("--[a-z-]+");
  std::set<std::string> flags;
  for (std::sregex_iterator at(text.begin(), text.end(), flag), end; at != end; ++at)
  {
    flags.insert(at->str());
  }
  return flags;
}
}

TEST(FlagWords, EachRemedyHasWordsThatNameNoPropertyOfAFilter)
{
  ASSERT_GT(vtkFlatteningAlgorithm::GetNumberOfRemedies(), 30);
  const std::regex property("[A-Z][a-z]+[A-Z]|[A-Z]+_[A-Z]+|[{}\\[\\]]");
  const std::regex flag("--[a-z-]+");
  const std::set<std::string> flags = flagsOfTheCommand();
  std::size_t named = 0;
  for (int k = 0; k < vtkFlatteningAlgorithm::GetNumberOfRemedies(); ++k)
  {
    const std::string name = vtkFlatteningAlgorithm::GetRemedyName(k);
    const std::string words = remedyWords(name);
    EXPECT_FALSE(words.empty()) << name;
    EXPECT_FALSE(std::regex_search(words, property)) << name << ": " << words;
    for (std::sregex_iterator at(words.begin(), words.end(), flag), end; at != end; ++at, ++named)
    {
      EXPECT_EQ(flags.count(at->str()), 1u) << name << ": " << words;
    }
  }
  EXPECT_GT(named, 20u);
}

TEST(FlagWords, AnUnknownRemedyHasNone)
{
  EXPECT_EQ(remedyWords("Despair"), "");
}

TEST(FlagWords, AMessageIsTheDefectAndItsRemedies)
{
  EXPECT_EQ(messageOf("it is broken", {}), "it is broken");
  EXPECT_EQ(messageOf("banks cross", { { "CloseCuts", "" }, { "Give", "a % sign" } }),
    "banks cross; close the cuts where they cross (--close-cuts), or give a % sign");
}
