// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedProcess.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <iostream>
#include <new>
#include <thread>

namespace
{
using namespace wirewarp;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Clock = std::chrono::steady_clock;

bool hasChildren()
{
  return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

bool isAlive(pid_t process)
{
  return kill(process, 0) == 0;
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
    const ProcessAnswer answer = runGuarded({}, [&]() { return text; });
    EXPECT_EQ(answer.end, ProcessEnd::Answered);
    EXPECT_TRUE(answer.bytes == text) << size;
  }
  EXPECT_FALSE(hasChildren());
}

TEST(GuardedProcess, ACrashIsToldByItsSignal)
{
  for (const int signal : { SIGSEGV, SIGABRT, SIGFPE, SIGKILL })
  {
    const ProcessAnswer answer = runGuarded({}, [signal]() {
      std::signal(signal, SIG_DFL); // sanitizers have handlers of their own
      std::raise(signal);
      return std::string();
    });
    EXPECT_EQ(answer.end, ProcessEnd::Signal);
    EXPECT_EQ(answer.signal, signal);
  }
  EXPECT_FALSE(hasChildren());
}

TEST(GuardedProcess, AnEndOfItsOwnIsNoAnswer)
{
  const ProcessAnswer answer = runGuarded({}, []() -> std::string { std::_Exit(0); });
  EXPECT_EQ(answer.end, ProcessEnd::Silent);
}

TEST(GuardedProcess, AnEndlessLoopEndsAtTheLimitOfTheProcessor)
{
  ProcessLimits limits;
  limits.cpu = seconds(1);
  const ProcessAnswer answer = runGuarded(limits, []() {
    for (volatile unsigned turn = 0;; turn = turn + 1)
    {
    }
    return std::string();
  });
  EXPECT_EQ(answer.end, ProcessEnd::TooLong);
  EXPECT_EQ(answer.signal, SIGXCPU);
  EXPECT_FALSE(hasChildren());
}

TEST(GuardedProcess, WaitingForEverEndsAtTheLimitOfTheClock)
{
  ProcessLimits limits;
  limits.wall = seconds(1);
  const Clock::time_point start = Clock::now();
  const ProcessAnswer answer = runGuarded(limits, []() {
    std::this_thread::sleep_for(seconds(600));
    return std::string();
  });
  EXPECT_EQ(answer.end, ProcessEnd::TooLong);
  EXPECT_EQ(answer.signal, 0);
  EXPECT_LT(Clock::now() - start, seconds(60));
  EXPECT_FALSE(hasChildren());
}

TEST(GuardedProcess, MemoryBeyondTheLimitIsNotToBeHad)
{
  const auto take = [](std::size_t size) {
    return [size]() {
      // Not by a new-expression, which a compiler may leave out.
      void* const block = ::operator new(size, std::nothrow);
      return std::string(block ? "taken" : "refused");
    };
  };
  ProcessLimits limits;
  limits.memory = std::size_t(1) << 28;
  EXPECT_EQ(runGuarded(limits, take(std::size_t(1) << 27)).bytes, "taken");
  EXPECT_EQ(runGuarded(limits, take(std::size_t(1) << 29)).bytes, "refused");
}

TEST(GuardedProcess, WhatItPrintsIsLost)
{
  testing::internal::CaptureStderr();
  runGuarded({}, []() {
    std::cerr << "malloc(): corrupted top size" << std::endl;
    return std::string();
  });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

#ifdef __linux__
TEST(GuardedProcess, ItDiesWithItsParent)
{
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0)
  {
    runGuarded({}, [&ends]() {
      const pid_t own = getpid();
      EXPECT_EQ(write(ends[1], &own, sizeof own), static_cast<ssize_t>(sizeof own));
      std::this_thread::sleep_for(seconds(600));
      return std::string();
    });
    std::_Exit(0);
  }
  pid_t guarded = 0;
  ASSERT_EQ(read(ends[0], &guarded, sizeof guarded), static_cast<ssize_t>(sizeof guarded));
  EXPECT_TRUE(isAlive(guarded));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  const Clock::time_point start = Clock::now();
  while (isAlive(guarded) && Clock::now() - start < seconds(20))
  {
    std::this_thread::sleep_for(milliseconds(5));
  }
  EXPECT_FALSE(isAlive(guarded));
  close(ends[0]);
  close(ends[1]);
}
#endif
}
