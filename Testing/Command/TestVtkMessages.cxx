// SPDX-License-Identifier: BSD-3-Clause
#include "VtkMessages.h"

#include <gtest/gtest.h>

#include <vtkOutputWindow.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace
{
using wirewarp::VtkMessages;

TEST(VtkMessages, AreTakenWithoutTheirPlaceAndAddress)
{
  VtkMessages messages;
  vtkOutputWindowDisplayErrorText("ERROR: In file.cxx, line 7\nvtkReader (0x1234): it ends\n\n");
  vtkOutputWindowDisplayWarningText("odd");
  EXPECT_EQ(messages.errors(), std::vector<std::string>{ "it ends" });
  EXPECT_EQ(messages.warnings(), std::vector<std::string>{ "odd" });
}

TEST(VtkMessages, OfAnInnerTakerAreNotThoseOfTheOuter)
{
  const VtkMessages outer;
  {
    const VtkMessages inner;
    vtkOutputWindowDisplayErrorText("inner");
    EXPECT_EQ(inner.firstError(), "inner");
  }
  vtkOutputWindowDisplayErrorText("outer");
  EXPECT_EQ(outer.errors(), std::vector<std::string>{ "outer" });
}

TEST(VtkMessages, ArePrintedAgainAfterwards)
{
  {
    const VtkMessages messages;
  }
  testing::internal::CaptureStderr();
  vtkOutputWindowDisplayErrorText("to be seen");
  EXPECT_NE(testing::internal::GetCapturedStderr().find("to be seen"), std::string::npos);
}

TEST(VtkMessages, MayBeTakenWhileAnotherThreadSpeaks)
{
  const VtkMessages outer; // so that nothing is printed in between
  std::atomic<bool> ended{ false };
  std::atomic<int> said{ 0 };
  std::thread speaker([&] {
    while (!ended)
    {
      vtkOutputWindowDisplayErrorText("word");
      ++said;
    }
  });
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  while (std::chrono::steady_clock::now() < end)
  {
    const VtkMessages messages;
  }
  ended = true;
  speaker.join();
  EXPECT_GT(said, 100);
}
}
