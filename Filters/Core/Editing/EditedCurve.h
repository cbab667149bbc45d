// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/FeatureCurve.h"
#include "Surface/SurfaceTrace.h"

#include <memory>
#include <optional>

namespace flattening
{
/// How a curve gets from one node to the next.
enum class SegmentKind
{
  Geodesic = 0, ///< the straight path over the surface
  Section = 1,  ///< in the plane through both nodes and the surface's normal
  Edges = 2,    ///< the shortest way along edges
  Spline = 3,   ///< the part between both of a smooth curve through all nodes
};

/// What a feature curve is, apart from where it runs.
struct CurveTraits
{
  std::string name;
  CurveType type = CurveType::Accessory;
  KeyShape keyShape = KeyShape::Surface;
  double tolerance = 0.0;
  LengthEase ease;
  /// There is the same on the other side of the mirror plane as well.
  bool mirrored = false;
};

/// A curve as its drawer sees it: nodes on the surface, and how it runs between them.
struct EditedCurve
{
  CurveTraits traits;
  bool closed = false;
  std::vector<SurfacePoint> nodes;
  std::vector<SegmentKind> kinds; ///< one a segment; a closed curve has as many as nodes
  // What follows from the above and is kept.
  std::vector<SurfacePath> segments;
  std::vector<SurfacePath> image; ///< in the mirror, where the curve is mirrored
};

/// That of a curve's image in the mirror. Which piece an image lies in is not known: none, where
/// the curve is eased in a piece that is named.
inline LengthEase easeOfImage(const LengthEase& ease)
{
  return ease.piece == none ? ease : LengthEase();
}

struct MirrorPlane
{
  Point3 origin = Point3::Zero();
  Point3 normal = Point3::UnitX(); ///< of length 1

  double height(const Point3& point) const { return this->normal.dot(point - this->origin); }
  Point3 image(const Point3& point) const
  {
    return point - 2.0 * this->height(point) * this->normal;
  }
};

/// All that an editor edits. Curves are shared between states and never changed in place.
struct CurveSet
{
  std::vector<std::shared_ptr<const EditedCurve>> curves;
  std::optional<MirrorPlane> mirror;
};

/// Whether a curve other than `except` has the name.
bool nameTaken(const CurveSet& set, const std::string& name, std::size_t except);
/// The wish, or with a number behind it where it is taken; "curve" and a number where it is empty.
std::string freeName(const CurveSet& set, const std::string& wish);

/// How many segments there are between nodes.
std::size_t segmentCount(std::size_t nodes, bool closed);
double lengthOf(const EditedCurve& curve);
/// All points from the first node on, once each; a closed curve ends where it starts.
Points3 pointsAlong(const std::vector<SurfacePath>& segments);
/// The segments as one path. \pre each has points
SurfacePath wholePath(const EditedCurve& curve);

/// Whether two are the same to the last bit.
bool identical(const EditedCurve& a, const EditedCurve& b);
bool identical(const CurveSet& a, const CurveSet& b);
}
