// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/LengthUnit.h"
#include "Base/Types.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace flattening::pattern
{
/// With the values of the array CurveType.
enum class WireType
{
  Boundary = -1,
  Accessory,
  Key,
  Dart,
  Seam,
};

/// A flat wire as point ids; both banks of a cut run in the direction of their curve.
struct SourceWire
{
  Indices points;
  WireType type = WireType::Boundary;
  Index curve = none;
  Index piece = none;
  std::string name;
};

/// The edge a is sewn to the edge b, first end to first end.
struct SewnEdges
{
  std::array<Index, 2> a{ none, none };
  std::array<Index, 2> b{ none, none };
  bool closed = false; ///< they lie on each other: the cut was closed, the cloth is whole there
};

enum class EdgeShape
{
  Straight,
  Quadratic, ///< parameters: control point, in the frame of the chord
  Cubic,     ///< parameters: two control points, in the frame of the chord
  Circle,    ///< parameters: radius, 1 for the larger arc, 1 for counter-clockwise
};

/// One edge of a panel. The frame of a chord from a to b has its origin at a, b - a as its first
/// axis and that turned to the left as its second, both of the length 1 in it.
struct GarmentEdge
{
  std::array<std::size_t, 2> ends{}; ///< vertices of the panel
  EdgeShape shape = EdgeShape::Straight;
  std::array<double, 4> parameters{};
  std::string label;
};

/// A flat piece of GarmentCode, and how it is placed in space.
struct GarmentPanel
{
  std::string name;
  std::string label;
  Points2 vertices;
  std::vector<GarmentEdge> edges; ///< each begins where the one before ends
  Point3 translation = Point3::Zero();
  Point3 rotation = Point3::Zero(); ///< degrees about x, then y, then z, which stay
};

struct GarmentSide
{
  std::size_t panel = 0;
  std::size_t edge = 0;

  bool operator==(const GarmentSide& other) const
  {
    return this->panel == other.panel && this->edge == other.edge;
  }
};

/// Two edges that are sewn together, the start of one to the end of the other.
struct GarmentStitch
{
  std::array<GarmentSide, 2> sides{};
  bool rightToWrong = false; ///< start to start instead
};

/// Panels and stitches as the JSON of GarmentCode has them. Lengths are centimetres in a file, and
/// those of panels that pieces were, but for where they are placed, in the unit of the surface.
struct Garment
{
  std::vector<GarmentPanel> panels;
  std::vector<GarmentStitch> stitches;
};

/// A flattening, in the unit of its surface.
struct PatternSource
{
  Points2 positions;
  Points3 inSpace; ///< the same points on the cut surface, or empty
  Triangles triangles;
  Indices pieceOfTriangle;
  std::vector<SourceWire> wires;
  std::vector<SewnEdges> sewn;
  Indices gradePoints; ///< with the rules 1, 2, ... of a grading, or none
  Garment garment;     ///< whose panels the pieces are; without panels where they are no such
  /// By piece, of what was flattened; empty where there is none.
  std::vector<std::string> pieceNames;
  bool onCloth = false; ///< the pieces lie on their cloth, its warp along y
  bool isSheet = false; ///< the edges of that cloth do not fray
};

/// The axis of the surface that points up.
enum class UpAxis
{
  Automatic, ///< of y and z that along which the surface is larger
  X,
  Y,
  Z,
  None, ///< pieces are drawn as they lie
};

/// In millimetres, where none is given: edges of a sheet do not fray.
constexpr double usualAllowance(bool isSheet)
{
  return isSheet ? 0.0 : 10.0;
}

/// How to make a pattern of a flattening. Lengths in millimetres whatever the unit of the surface.
struct PatternOptions
{
  Unit unit = Unit::Centimetre;
  std::string name = "pattern";
  std::string size;
  int quantity = 1;
  std::vector<int> pieceQuantities;    ///< by piece; where missing or 0: quantity
  std::vector<std::string> pieceNames; ///< by piece; where missing: the name, numbered if need be
  double allowance = -1.0;             ///< below 0: usualAllowance()
  std::map<std::string, double> allowanceOfCurve; ///< by curve name; "boundary" for the rest
  double mitreLimit = 2.0;                        ///< longest mitre, in allowances
  double warpCompensation = 0.0; ///< by which pieces are longer along their grain, per cent
  double weftCompensation = 0.0; ///< the same across it
  double thickness = 0.0;        ///< of the material, for bevels of joins, millimetres
  double glueTab = 0.0;          ///< width of tabs on the first side of each join, millimetres
  /// Along the curve, on the surface; 0: at mouths of darts alone; below 0: about a sixth of the
  /// largest piece.
  double notchSpacing = -1.0;
  std::map<std::string, std::vector<double>>
    notchesOfCurve; ///< by curve name, distances from its start in place of the spacing
  std::set<std::string> doubleNotches; ///< names of curves whose notches are two marks
  bool notchCorners = false;           ///< notches where the sew lines of a corner end
  bool notchCurveEnds = false;         ///< notches where curves meet the border
  double notchLength = 5.0;
  UpAxis up = UpAxis::Automatic; ///< of pieces without a grain of their own
  bool joinMarks = true; ///< A, B, ... at both ends and in the middle of what is sewn together
  /// The cloth of darts is cut away, and their legs are seams with allowance; off: it stays, with
  /// legs, fold line, notches at the mouth and a roof on the cut line.
  bool cutDartsOut = false;
  /// Of smooth borders and curves from the flat pieces, but panels, which are smooth; 0: as these
  /// are.
  double fairTolerance = 0.2;
  std::map<std::string, double> fairToleranceOfCurve; ///< by curve name; "boundary" for the rest
  bool symmetrize = false; ///< smooth outlines of symmetric pieces are their own mirror images
  double dartTip = 0.0;    ///< how far tips of folded darts are drawn back
  std::map<std::string, double> dartTipOfCurve; ///< by name of the dart
  bool cutOnFold = false;                       ///< of symmetric pieces draw a half
  std::set<std::string> foldsAlong; ///< names of curves along which pieces are cut on the fold
  bool oneLayer = false;            ///< the cloth is not folded: pieces are drawn whole
  bool pairs =
    false; ///< of two pieces that are mirror images draw the first alone, to be cut twice

  /// What is common to lines of a source that have no tolerance of their own.
  double fairToleranceOf(const PatternSource& source) const
  {
    return source.garment.panels.empty() ? this->fairTolerance : 0.0;
  }
  /// Whether any line is to be smooth.
  bool isFair(const PatternSource& source) const
  {
    return this->fairToleranceOf(source) > 0.0 ||
      std::any_of(this->fairToleranceOfCurve.begin(), this->fairToleranceOfCurve.end(),
        [](const auto& ofCurve) { return ofCurve.second > 0.0; });
  }
};
}
