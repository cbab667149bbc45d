// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathGraph.h"
#include "Quality/ScaleFactor.h"
#include "Suggestion/BoundaryRuler.h"
#include "Suggestion/CurveSuggestions.h"
#include "Surface/SurfaceLocator.h"

#include <optional>

namespace flattening
{
/// How a plan stands to the mirror plane, or the axis of an intrinsic mirror.
enum class MirrorRole
{
  Alone, ///< there is no plane, or it is not kept
  Pair,  ///< comes with its mirror image
  Along, ///< lies in the plane
  Across ///< a seam from a point to its mirror image
};

/// A cut to be tried on a surface with a boundary: a straight line on it.
struct CutPlan
{
  CurveType type = CurveType::Dart;
  MirrorRole role = MirrorRole::Alone;
  BoundaryPlace base;          ///< the mouth of a dart, an end of a seam
  BoundaryPlace end;           ///< of a seam
  Point3 tip = Point3::Zero(); ///< of a dart
  std::optional<Point3> start; ///< of a dart inside, as at a waist: its other tip; it has no base
  std::optional<Point3> via;   ///< of a seam: where it runs over a peak; straight before and behind
  /// What its line would change, by ScaleFactor.
  double predictedGain = 0.0;
  double opening = 0.0;
  double length = 0.0; ///< along edges; with its mirror image
  double price = 0.0;

  double score() const { return this->predictedGain / this->price; }
};

/// A piece of the surface with what a search for cuts asks of it again and again.
class SearchedPiece
{
public:
  /// \param barred per vertex, whether it lies on a key curve, which no cut may cross
  /// \param preference per vertex, what the price of a cut that begins or ends there is divided by;
  /// 0: none may
  /// \param weight per vertex, how much distortion matters there; empty: everywhere alike
  SearchedPiece(TriangleMesh mesh, std::vector<char> barred, std::vector<double> preference,
    std::vector<double> weight, const std::optional<SurfaceMirror>& mirror);
  SearchedPiece(const SearchedPiece&) = delete;
  SearchedPiece& operator=(const SearchedPiece&) = delete;

  const TriangleMesh& mesh() const { return this->Mesh; }
  const BoundaryRuler& ruler() const { return this->Ruler; }
  const std::vector<char>& barred() const { return this->Barred; }
  double endpointPreference(const BoundaryPlace& place) const;
  const std::vector<double>& weight() const { return this->Weight; }
  double area() const { return this->Area; }
  /// R = sqrt(area / pi)
  double size() const { return this->Size; }
  /// The plane, where it mirrors this piece onto itself.
  const std::optional<SurfaceMirror>& mirror() const { return this->Mirror; }
  /// Mirror images lie on the piece but for rounding.
  bool mirrorIsExact() const;
  Index mirrored(Index vertex) const { return this->MirrorVertex[vertex]; }
  /// The nearest point of the surface. \param inMirror of the plane or axis, that next to the point
  Point3 onto(const Point3& point, bool inMirror = false) const
  {
    return this->Locator.closest(inMirror ? this->Mirror->projected(point) : point).position;
  }
  Point3 normalNear(const Point3& point) const;
  /// Whether a dart inside may end there: it is not so near to the boundary, or to a cut, that the
  /// dart had better begin at it.
  bool takesInnerTip(const Point3& point) const;

  Point3 baseOf(const CutPlan& plan) const
  {
    return plan.start ? *plan.start : this->Ruler.point(plan.base);
  }
  Point3 endOf(const CutPlan& plan) const;
  BoundaryPlace mirrored(const BoundaryPlace& place) const;
  /// The lines to cut, straight on the surface: one, or two that are mirror images. Empty where
  /// there is no way.
  std::vector<Polyline> polylines(const CutPlan& plan) const;
  /// What a plan costs whose lines have this length in all.
  double price(const CutPlan& plan, double length, const SearchOptions& options) const;

private:
  void findMirrorVertices();
  double slant(const CutPlan& plan) const;
  Points3 straightLine(
    const SurfacePoint& from, const std::optional<SurfacePoint>& via, const SurfacePoint& to) const;
  SurfacePoint surfacePoint(const Point3& point) const;

  TriangleMesh Mesh;
  std::vector<char> Barred;
  std::vector<double> Preference;
  std::vector<double> Weight;
  double Area = 0.0;
  double Size = 0.0;
  BoundaryRuler Ruler;
  SurfaceLocator Locator;
  PathGraph Graph;
  SnapDistance Snap;
  std::optional<SurfaceMirror> Mirror;
  Indices MirrorVertex;
};
}
