// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SettledCuts.h"

#include "Suggestion/CutThinning.h"

#include <algorithm>

namespace flattening
{
std::vector<Polyline> settledCuts(const CutTrials& trials, const std::vector<Polyline>& others,
  const std::vector<Polyline>& lines, const SearchedPiece& piece)
{
  std::vector<Polyline> all = others;
  all.insert(all.end(), lines.begin(), lines.end());
  const std::vector<Points3> paths = trials.paths(all);
  if (paths.empty())
  {
    return {};
  }
  std::vector<Polyline> settled = lines;
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    settled[k].points = paths[others.size() + k];
  }
  if (settled.size() == 2 && settled[0].type == CurveType::Dart)
  {
    // Where the mirror is not exact, sewing is easier by a dart that stops short than by a pair
    // that differs.
    const double first = lengthOf(settled[0].points);
    const double second = lengthOf(settled[1].points);
    Points3& longer = settled[first > second ? 0 : 1].points;
    longer = shortened(longer, std::min(first, second));
  }
  if (settled.size() == 2 && piece.mirrorIsExact())
  {
    settled[1].points = settled[0].points;
    for (Point3& p : settled[1].points)
    {
      p = piece.mirror()->mirrored(p);
    }
  }
  return settled;
}
}
