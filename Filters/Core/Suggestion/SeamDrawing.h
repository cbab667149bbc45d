// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/ImprintedSurface.h"
#include "Paths/PathGraph.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/SurfacePoint.h"

namespace flattening
{
/// Cosines of how far a surface turns at least at a crease, by 30 degrees, and at a sharp edge, by
/// 50, which coarse meshes of smooth surfaces hardly have.
inline constexpr double creaseCosine = 0.866;
inline constexpr double sharpCosine = 0.643;

bool isCrease(const TriangleMesh& mesh, Index halfedge, double cosine = creaseCosine);

/// By half-edge whether it is a crease. None is where more than half of the vertices are on
/// creases, as on a scan.
std::vector<char> creasesOf(const TriangleMesh& mesh, double cosine);

/// Draws seams on a surface from chains of places, more or less smooth.
class SeamDrawing
{
public:
  /// How near to its chain a line stays: drawn tight; within some steps of the chain; not
  /// smoothed at all.
  static constexpr int levels = 5;
  /// What drawing and imprinting takes, in steps of a flattening.
  static constexpr double steps = 5.0;

  /// The mesh must outlive it.
  explicit SeamDrawing(const TriangleMesh& mesh);

  /// The places of the surface next to the points of a line; vertices where some are near.
  std::vector<SurfacePoint> place(const Points3& line) const;
  /// The places on another surface next to the images of a chain on this one: on the boundary where
  /// those of the chain are.
  std::vector<SurfacePoint> imageOn(const SeamDrawing& other,
    const std::vector<SurfacePoint>& chain, const SymmetryPlane& plane) const;
  /// From place to place: along creases and boundaries as they are, elsewhere smooth. No points
  /// where there is no way to a place.
  Points3 draw(const std::vector<SurfacePoint>& chain, int level) const;
  /// The same line on this surface, which it need not lie on.
  Points3 moved(const Points3& line) const { return this->draw(this->place(line), levels - 1); }

private:
  bool exact(const SurfacePoint& from, const SurfacePoint& to) const;

  const TriangleMesh& Mesh;
  PathGraph Graph;
  SheetLocator Locator;
  SnapDistance Snap;
};

/// Sets of lines that cannot be laid into a surface together: that meet elsewhere than at ends of
/// all of them, run along the boundary, or end as a dart on others. All of them, each alone, where
/// it is not known which. \param count of lines
std::vector<Indices> failingLines(const ImprintedSurface& imprinted, std::size_t count);

/// Raises the lowest level in each set, of equal ones that of the last. False where all are
/// highest.
/// \param ownerOf by member of the sets, whose level it is
bool raiseLevels(
  const std::vector<Indices>& sets, const Indices& ownerOf, std::vector<int>& levels);
}
