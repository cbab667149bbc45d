// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace wirewarp
{
/// Words of the command line in the order of vtkWireWarpingFilter's enumerations.
constexpr std::array<const char*, 4> schemeNames{ "progressive", "global", "isometric", "lscm" };
constexpr std::array<const char*, 2> solverNames{ "newton", "sequential" };
constexpr std::array<const char*, 3> interiorNames{ "laplacian", "relaxation", "arap" };
constexpr std::array<const char*, 2> energyNames{ "rigid", "dirichlet" };
constexpr std::array<const char*, 3> dartLegNames{ "free", "straight", "mirrored" };
/// Of vtkFeatureCurveSuggestion's.
constexpr std::array<const char*, 4> suggestNames{ "darts", "seams", "all", "lines" };

/// \return the place of the word; \pre it is among the names
template <std::size_t count>
int valueOf(const std::array<const char*, count>& names, const std::string& word)
{
  int value = 0;
  while (names[static_cast<std::size_t>(value)] != word)
  {
    ++value;
  }
  return value;
}
}
