// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TriangleList.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wirewarp
{
/// A plane across an axis, and between which planes across axes its section is taken.
struct SectionPlane
{
  struct Bound
  {
    std::size_t axis = 0;
    double place = 0.0;
    bool above = true;
  };
  std::size_t axis = 0;
  double place = 0.0;
  std::vector<Bound> bounds;
};

/// "x=0", "z=120 y>0 x<30". None where the words are not of this form.
std::optional<SectionPlane> sectionPlaneOf(std::string_view words);

using SectionLine = Points3;

/// Where a plane cuts a surface, the longest line first; closed ones end where they begin. Vertices
/// in the plane count as on its upper side.
std::vector<SectionLine> sectionOf(const TriangleList& list, const SectionPlane& plane);
}
