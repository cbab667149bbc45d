// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BorderWays.h"
#include "CurveList.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wirewarp
{
class LineReader;

/// What the word for the type of a curve says.
struct RowType
{
  CurveKind kind;
  bool isEdge = false; ///< an accessory curve along the boundary
};

/// \param word as curveKindOf() has it, or edge. Throws InputError where it is another one.
RowType rowType(std::string_view word, const LineReader& lines);

/// Makes the curves of a text or a table, which are given by points or by words:
///   plane x=0 y>10        where a plane across an axis cuts the surface, on sides of others
///   opening 2             all around an opening, as `wirewarp check` numbers them
///   boundary left         the opening farthest to the left (right, top, bottom, front, back)
///   boundary waist        along an earlier curve of this name
///   between waist and hem the straight way from one opening or earlier curve to the other
/// Throws InputError with file and line.
class CurveBuilder
{
public:
  /// \param lines of the file, for messages. It and the surface must outlive this.
  /// \param overSurface curves are over the points of the surface and new ones, else new ones alone
  CurveBuilder(const LineReader& lines, const DataSet& surface, bool overSurface);

  /// Whether words are of one of these forms.
  static bool areWords(std::string_view text);
  /// Adds the curves that words name, the longest first.
  void addWords(const CurveTitle& title, bool isEdge, std::string_view words);
  /// Adds a curve through new points.
  void addLine(const CurveTitle& title, const Points3& line);
  /// Adds a curve through points by their ids; an edge follows the boundary of the surface from
  /// each of its vertices to the next.
  void addIds(const CurveTitle& title, bool isEdge, const std::vector<std::int64_t>& ids);

  /// The id of a new point.
  std::int64_t newPoint(const Point3& place);
  /// The vertex of the boundary that is nearest along it to a point of an edge, which lies on it.
  std::int64_t borderVertex(const Point3& place, const std::string& edge);

  bool empty() const { return this->Curves.empty(); }
  DataSet take();

private:
  struct Line
  {
    Points3 points;                     ///< a closed line ends where it begins
    std::vector<std::int64_t> ids = {}; ///< of these points; empty: new ones
  };

  const Points3& places() const { return this->Added ? *this->Added : *this->Points; }
  Points3& added();
  const BorderWays& borders();
  void add(const CurveTitle& title, const Line& line);
  Points3 placesOf(const std::vector<std::int64_t>& ids, const Points3& points) const;
  std::vector<Line> linesOf(std::string_view words, bool isEdge) const;
  Line boundary(std::string_view words) const;
  std::vector<Line> sections(std::string_view words) const;
  Line between(std::string_view words) const;
  Points3 pointsOf(std::string_view& words) const;

  const LineReader& Lines;
  const DataSet& Surface;
  const bool OverSurface;
  std::shared_ptr<const Points3> Points;
  std::shared_ptr<Points3> Added; ///< these and new ones; null: there is none
  CurveList Curves;
  std::map<std::string, Points3> Known; ///< points of curves by their names
  std::optional<BorderWays> Borders;    ///< made where an edge needs them
};
}
