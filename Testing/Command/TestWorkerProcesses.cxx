// SPDX-License-Identifier: BSD-3-Clause
#include "WorkerProcesses.h"

#include <gtest/gtest.h>

#include <csignal>
#include <map>

namespace
{
using namespace wirewarp;

using Texts = std::map<std::size_t, std::optional<std::string>>;

Texts run(
  std::size_t count, std::size_t workers, const std::function<std::string(std::size_t)>& job)
{
  Texts texts;
  runInProcesses(count, workers, job, [&](std::size_t k, const std::optional<std::string>& text) {
    EXPECT_TRUE(texts.emplace(k, text).second) << "job " << k << " ended twice";
  });
  return texts;
}

TEST(WorkerProcesses, EachJobRunsOnceAndItsTextComesBack)
{
  EXPECT_TRUE(run(0, 3, [](std::size_t) { return std::string(); }).empty());
  for (const std::size_t workers : { 1, 2, 40 })
  {
    // Longer than what a pipe takes at once.
    const Texts texts =
      run(20, workers, [](std::size_t k) { return std::string(100000 * (k % 5), char('a' + k)); });
    ASSERT_EQ(texts.size(), 20u);
    for (const auto& [k, text] : texts)
    {
      EXPECT_EQ(text, std::string(100000 * (k % 5), char('a' + k)));
    }
  }
}

TEST(WorkerProcesses, AJobThatDiesTakesNoOtherWithIt)
{
  const Texts texts = run(9, 2, [](std::size_t k) {
    if (k % 3 == 1)
    {
      std::raise(SIGKILL);
    }
    return std::to_string(k);
  });
  ASSERT_EQ(texts.size(), 9u);
  for (const auto& [k, text] : texts)
  {
    EXPECT_EQ(text.has_value(), k % 3 != 1) << k;
  }
}
}
