// SPDX-License-Identifier: BSD-3-Clause
// What TestGuardedProcess.cxx runs: the first argument says what to do, the second how much of it.
#include "GuardedProcess.h"

#include <fcntl.h>

#include <chrono>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace
{
std::string work(const std::vector<std::string>& arguments)
{
  const std::string& task = arguments.at(0);
  const std::string& amount = arguments.at(1);
  if (task == "answer")
  {
    std::string text(std::stoul(amount), 'x');
    for (std::size_t k = 0; k < text.size(); ++k)
    {
      text[k] = static_cast<char>(k * k >> 3);
    }
    return text;
  }
  if (task == "take")
  {
    // Not by a new-expression, which a compiler may leave out.
    return ::operator new(std::stoul(amount), std::nothrow) ? "taken" : "refused";
  }
  if (task == "wait")
  {
    std::this_thread::sleep_for(std::chrono::seconds(600));
  }
  else if (task == "open") // how many files are open beside its own streams
  {
    int open = 0;
    for (int file = 3; file < 200; ++file)
    {
      open += fcntl(file, F_GETFD) >= 0 ? 1 : 0;
    }
    return std::to_string(open);
  }
  return {};
}
}

int main(int argc, char** argv)
{
  return wirewarp::answerGuarded(argc, argv, work);
}
