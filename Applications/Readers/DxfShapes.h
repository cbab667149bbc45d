// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace wirewarp
{
/// A point of a drawing.
using DxfPlace = std::array<double, 3>;

/// An entity of the section ENTITIES, or a VERTEX of one, with its groups in the order of the file.
/// Group codes: AutoCAD's "DXF Reference".
struct DxfEntity
{
  std::string kind; ///< of group 0
  std::string layer = "0";
  std::string handle;                                     ///< empty where the file has none
  std::size_t line = 0;                                   ///< of its kind, counted from 1
  std::vector<std::pair<int, double>> numbers;            ///< groups 10 to 79 and 210 to 239
  std::vector<std::pair<DxfPlace, double>> vertices = {}; ///< of a POLYLINE, with their bulges

  double number(int code, double otherwise) const;
  std::vector<double> all(int code) const;
  /// Points of the groups code, code + 10 and code + 20.
  std::vector<DxfPlace> places(int code) const;
  bool hasFlag(long long flag) const; ///< of group 70
};

/// An entity as a chain of points.
struct DxfCourse
{
  std::vector<DxfPlace> places; ///< each once
  bool closed = false;
  std::string fault; ///< why there are no places, where that is a defect of the file
};

/// Whether courseOf() knows a kind of entity.
bool isDxfCurve(const DxfEntity& entity);

/// The course of a LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE or SPLINE in the coordinates of
/// the drawing. Arcs (bulges included) and splines become chords that leave them by at most 1e-4 of
/// the size of the entity. A spline is computed by de Boor's algorithm from its control points,
/// knots and weights. Entities of a plane go from the coordinates of their extrusion (groups 210 to
/// 230) to those of the drawing by the "arbitrary axis algorithm" of the reference.
DxfCourse courseOf(const DxfEntity& entity);
}
