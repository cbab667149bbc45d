// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wirewarp
{
using flattening::DataSet;
using flattening::Point3;
using flattening::Points3;

/// What a word says a curve is: values of the cell arrays CurveType and KeyShape.
struct CurveKind
{
  int type = 0;
  int keyShape = 0;
};

/// What accessory, key, dart, seam or straight (a key that is straight in the plane) stands for, in
/// letters of any case; none for another word.
std::optional<CurveKind> curveKindOf(std::string_view word);
inline constexpr const char* curveKindWords = "accessory, key, straight, dart or seam";
/// Whether a word is edge, in letters of any case: an accessory curve along the boundary.
bool isEdgeWord(std::string_view word);

/// Curves that were read, and what was left out of them; empty where nothing was.
struct CurveContents
{
  DataSet curves;
  std::string note = {};
};

/// What the name of a group or layer says of a curve.
struct CurveTitle
{
  CurveKind kind; ///< accessory, where the first word is no type
  std::string name;
};

/// "dart left" is a dart called left, "Key" a key called Key, "hem line" an accessory curve of that
/// name. Words are divided by blanks, and before the name also by -, _ or :.
CurveTitle curveTitle(std::string_view text);

/// Curves as a reader finds them, one after the other.
class CurveList
{
public:
  void add(const std::vector<std::int64_t>& ids, const CurveTitle& title);
  /// A curve through new points, which are added to others; closed where it ends as it begins.
  void add(const Points3& line, Points3& places, const CurveTitle& title);
  bool empty() const { return this->Lines.size() == 0; }
  /// The curves over points, with the cell arrays CurveType, CurveName and, where one is straight,
  /// KeyShape.
  DataSet over(std::shared_ptr<const Points3> points) const;

private:
  flattening::CellList Lines;
  std::vector<int> Types;
  std::vector<int> Shapes;
  std::vector<std::string> Names;
};
}
