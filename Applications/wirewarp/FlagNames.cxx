// SPDX-License-Identifier: BSD-3-Clause
#include "FlagNames.h"

#include <array>

namespace wirewarp
{
namespace
{
struct Words
{
  const char* library;
  const char* command;
};

constexpr std::array<Words, 10> dictionary{ {
  { "raise the imprint tolerance", "raise --imprint-tolerance" },
  { "raise the snap distance", "raise --snap-tolerance" },
  { "allow triangles to be split", "leave out --no-split" },
  { "(option close cuts)", "(--close-cuts)" },
  { "(option skip closed)", "(--skip-closed)" },
  { "use the Newton solver", "use --solver newton" },
  { "the relaxation needs 0 <= minimum <= maximum iterations",
    "the relaxation needs --relaxation-min-iterations <= --relaxation-max-iterations" },
  { "name two, or -1 for both", "name two with --pins, or leave it out" },
  { "to have a length tolerance", "for --tolerance" },
  { "as rigid as possible; allow more iterations",
    "as rigid as possible; allow more with --rigid-iterations" },
} };
}

//------------------------------------------------------------------------------
std::string withFlags(std::string message)
{
  for (const Words& words : dictionary)
  {
    const std::string library = words.library;
    const std::size_t at = message.find(library);
    if (at != std::string::npos)
    {
      message.replace(at, library.size(), words.command);
    }
  }
  return message;
}
}
