// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wirewarp
{
struct SectionPlane;

/// Curves that are given by words instead of points:
///   plane x=0 y>10        where a plane across an axis cuts the surface, on sides of others
///   opening 2             all around an opening, as `wirewarp check` numbers them
///   boundary left         the opening farthest to the left (right, top, bottom, front, back)
///   boundary waist        along an earlier curve of this name
///   between waist and hem the straight way from one opening or earlier curve to the other
class CurveWords
{
public:
  struct Line
  {
    Points3 points;                          ///< a closed line ends where it begins
    std::vector<std::int64_t> vertices = {}; ///< the same of the surface, of an opening
  };

  /// The surface must outlive it.
  explicit CurveWords(const DataSet& surface)
    : Surface(surface)
  {
  }

  /// Whether words are of one of these forms.
  static bool areWords(std::string_view text);
  /// The curves that words name, the longest first. None with a fault where there are none.
  std::vector<Line> lines(std::string_view words, bool isEdge, std::string& fault) const;
  /// Makes a curve known by its name.
  void keep(const std::string& name, const Points3& points);

private:
  std::vector<Line> boundary(std::string_view words, std::string& fault) const;
  std::vector<Line> sections(std::string_view words, std::string& fault) const;
  std::vector<Line> between(std::string_view words, std::string& fault) const;
  Points3 pointsOf(std::string_view& words, std::string& fault) const;

  const DataSet& Surface;
  std::map<std::string, Points3> Known;
};
}
