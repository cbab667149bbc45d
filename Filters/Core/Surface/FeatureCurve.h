// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <string>

namespace flattening
{
/// Role of a feature curve (Definitions 2 and 3 of the paper; a seam separates pieces).
enum class CurveType
{
  Accessory = 0,
  Key = 1,
  Dart = 2,
  Seam = 3,
};

/// What prescribes the planar shape of a key curve.
enum class KeyShape
{
  Surface = 0,  ///< the angles that it has on the surface, Eq. 1
  Straight = 1, ///< a straight line
  Planar = 2,   ///< the turning angles of FeatureCurve::planarShape
};

/// By how much a curve is longer in one of its pieces than on the surface.
struct LengthEase
{
  double fraction = 0.0; ///< 0: no ease
  Index piece = none;    ///< none: the only one that the curve is in

  bool operator==(const LengthEase& other) const
  {
    return this->fraction == other.fraction && this->piece == other.piece;
  }
};

/// A feature curve as a chain of mesh vertices, each two neighbours joined by a mesh edge.
struct FeatureCurve
{
  std::string name;
  CurveType type = CurveType::Accessory;
  KeyShape keyShape = KeyShape::Surface;
  /// Elastic curves: how far each length may go from that on the surface, as a fraction; 0 is
  /// rigid.
  double tolerance = 0.0;
  LengthEase ease;
  Indices vertices;
  /// As many points as vertices, where keyShape is Planar.
  Points2 planarShape;

  /// Whether the surface is cut along it.
  bool opens() const { return this->type == CurveType::Dart || this->type == CurveType::Seam; }
  bool closed() const
  {
    return this->vertices.size() > 2 && this->vertices.front() == this->vertices.back();
  }
};

/// A feature curve as it comes in: points in space on or near the surface.
struct Polyline
{
  std::string name;
  CurveType type = CurveType::Accessory;
  KeyShape keyShape = KeyShape::Surface;
  double tolerance = 0.0;
  LengthEase ease;
  Points3 points;
  Points2 planarShape;
  /// Ids of the points in the caller's data, for messages.
  Indices pointIds;
};

/// Calls visit(a, b) for each two vertices of a line that follow each other.
template <class Visit>
void forEachEdge(const Indices& line, const Visit& visit)
{
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
  {
    visit(line[k], line[k + 1]);
  }
}

/// "accessory", "key", "dart" or "seam".
inline const char* curveTypeName(CurveType type)
{
  switch (type)
  {
    case CurveType::Accessory:
      return "accessory";
    case CurveType::Key:
      return "key";
    case CurveType::Dart:
      return "dart";
    case CurveType::Seam:
      return "seam";
  }
  return "unknown";
}

/// Names of curves for a message, each in quotes.
inline std::string quotedNames(const std::vector<FeatureCurve>& curves, const Indices& ids)
{
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    text += (i == 0 ? "\"" : i + 1 == ids.size() ? " and \"" : ", \"") + curves[ids[i]].name + "\"";
  }
  return text;
}
}
