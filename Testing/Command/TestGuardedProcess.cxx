// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedProcess.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

namespace
{
using namespace wirewarp;
using std::chrono::seconds;
using Clock = std::chrono::steady_clock;

ProcessAnswer run(
  const std::string& task, const std::string& amount, const ProcessLimits& limits = {})
{
  return runGuarded(limits, GUARDED_JOB, { task, amount });
}

bool hasChildren()
{
  return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

TEST(GuardedProcess, AnAnswerOfAnyLengthComesBack)
{
  for (const std::size_t size : { 0, 1, 8, 65536, 30000000 })
  {
    std::string text(size, 'x');
    for (std::size_t k = 0; k < size; ++k)
    {
      text[k] = static_cast<char>(k * k >> 3);
    }
    const ProcessAnswer answer = run("answer", std::to_string(size));
    EXPECT_EQ(answer.end, ProcessEnd::Answered);
    EXPECT_TRUE(answer.bytes == text) << size;
  }
  EXPECT_FALSE(hasChildren());
}

TEST(GuardedProcess, WaitingForEverEndsAtTheLimitOfTheClock)
{
  ProcessLimits limits;
  limits.wall = seconds(1);
  const Clock::time_point start = Clock::now();
  const ProcessAnswer answer = run("wait", "", limits);
  EXPECT_EQ(answer.end, ProcessEnd::TooLong);
  EXPECT_EQ(answer.signal, 0);
  EXPECT_LT(Clock::now() - start, seconds(60));
  EXPECT_FALSE(hasChildren());
}

TEST(GuardedProcess, MemoryBeyondTheLimitIsNotToBeHad)
{
  ProcessLimits limits;
  limits.memory = std::size_t(1) << 29; // programs and threads take some of it themselves
  EXPECT_EQ(run("take", std::to_string(std::size_t(1) << 27), limits).bytes, "taken");
  EXPECT_EQ(run("take", std::to_string(std::size_t(1) << 30), limits).bytes, "refused");
}

// A copy of this process would find the lock of malloc or of a stream held by a thread that it does
// not have, and wait until its limit.
TEST(GuardedProcess, AnswersWhileOtherThreadsAllocateAndPrint)
{
  std::atomic<bool> ended{ false };
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
  {
    threads.emplace_back([&ended] {
      while (!ended)
      {
        std::vector<std::string> texts;
        for (int n = 0; n < 50; ++n)
        {
          texts.emplace_back(static_cast<std::size_t>(100 * n), 'x');
        }
        std::fflush(nullptr);
      }
    });
  }
  ProcessLimits limits;
  limits.wall = seconds(20);
  int answered = 0;
  for (int k = 0; k < 30; ++k)
  {
    const ProcessAnswer answer = run("answer", "100000", limits);
    answered += answer.end == ProcessEnd::Answered && answer.bytes.size() == 100000 ? 1 : 0;
    if (answer.end == ProcessEnd::TooLong)
    {
      break;
    }
  }
  ended = true;
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(answered, 30);
}

#ifdef __linux__
TEST(GuardedProcess, HasNoEndOfThePipeButTheAnswers)
{
  int inherited = 0; // of who runs the test
  for (int file = 3; file < 200; ++file)
  {
    inherited += fcntl(file, F_GETFD) == 0 ? 1 : 0;
  }
  EXPECT_EQ(run("open", "").bytes, std::to_string(inherited + 1));
}
#endif
}
