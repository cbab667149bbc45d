// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PatternPicture.h"

#include <vtkFeatureCurveImprinter.h>
#include <vtkNew.h>
#include <vtkWireWarpingFilter.h>

#include <array>
#include <string>
#include <vector>

namespace viewer
{
using figures::PolyData;

/// What a curve is to the flattening.
enum class Role
{
  Accessory,
  Key,
  Released, ///< no wire
  Cut       ///< dart or seam; stays what it is
};

const char* nameOf(Role role);

struct Segment
{
  std::array<double, 3> start;
  std::array<double, 3> end;
};

/// A surface whose curves change their roles, and its flat pieces.
class PatternModel
{
public:
  /// Throws std::runtime_error where the input is refused.
  /// @param curves, released curves on the surface, wires and others; may be null
  PatternModel(const PolyData& surface, const PolyData& curves, const PolyData& released);

  int numberOfCurves() const { return static_cast<int>(this->Roles.size()); }
  std::string curveName(int curve) const;
  Role role(int curve) const { return this->Roles[curve]; }
  /// Accessory, key, released, and round again; flattens anew. A refused change is undone.
  /// @return whether the curve has another role now
  bool advance(int curve);

  vtkWireWarpingFilter* filter() { return this->Filter; }
  /// Throws std::runtime_error with the filter's message where it refuses.
  void flatten();
  const figures::FlatPiece& result() const { return this->Result; }
  /// What the filter said of the last run; empty where all is well.
  const std::string& message() const { return this->Message; }

  /// A curve's edges on the cut surface or in the plane. Of the sides of a cut, one.
  std::vector<Segment> segments(int curve, bool inPlane) const;
  /// The curves that are no wires, as lines.
  PolyData releasedLines(bool inPlane) const;

  /// Writes the wires and, where there are any, the released curves, as .vtp for this program and
  /// wirewarp. Throws std::runtime_error.
  /// @return the files
  std::vector<std::string> writeCurves(const std::string& prefix) const;
  /// Throws std::runtime_error.
  void writePattern(const std::string& path, const std::string& unit) const;

private:
  /// The imprinted curves of some roles.
  PolyData curvesOf(bool released) const;
  void findEdges();
  void updateCopies();

  vtkNew<vtkFeatureCurveImprinter> Imprinter; ///< owns the surface whose edges the curves are
  vtkNew<vtkWireWarpingFilter> Filter;
  figures::FlatPiece Result;
  std::string Message;
  std::vector<Role> Roles;
  /// An edge of a curve in a triangle of the imprinted surface.
  struct Edge
  {
    vtkIdType triangle;
    vtkIdType start;
    vtkIdType end;
  };
  std::vector<std::vector<Edge>> Edges;  ///< of each curve
  std::vector<vtkIdType> TriangleCopies; ///< cell of the result of each triangle
};
}
