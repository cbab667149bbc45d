// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Quality/StrainMeasures.h"
#include "Surface/TriangleFrame.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Measures of a flattening as a whole (Eqs. 26, 27).
struct QualitySummary
{
  double edgeLengthError = 0.0;         ///< E_len, Eq. 26, over the given edges
  double maximumEdgeLengthError = 0.0;  ///< largest |l - l0| / l0
  double resolvedEdgeLengthError = 0.0; ///< the same by EdgeLengthError::resolved
  double edgeLengthErrorAll = 0.0;      ///< mean of the same over all edges of the mesh
  double angleError = 0.0;              ///< E_ang, Eq. 27
  double globalHomogeneity = 0.0; ///< E_h = min a / max a, not positive where a triangle is flipped
  double globalAspectRatio = 0.0; ///< E_r = min s / max S
  double areaError = 0.0;         ///< E_area = sum |A2D - A3D| / sum A3D
  double strainP95 = 0.0;         ///< see StrainMeasures
  double rigidEnergy = 0.0;       ///< see StrainMeasures
  Indices flipped;                ///< triangles with a <= 0
};

struct FlatteningQuality
{
  std::vector<TriangleQuality> triangles;
  QualitySummary summary;
};

/// The relative error |l - l0| / l0 of an edge's length.
struct EdgeLengthError
{
  double measured = 0.0;
  double resolved = 0.0; ///< less what roundingOfLength() explains
};

/// How well coordinates in double precision can give the distance of two points: badly where it is
/// short beside their distance from the origin.
double roundingOfLength(const Point2& a, const Point2& b);

/// \param a, b the ends of the edge. An edge without length has no error.
EdgeLengthError edgeLengthError(
  const TriangleMesh& mesh, const Points2& positions, Index a, Index b);

/// What a flattening is measured by: the surface's own angles and areas.
struct SurfaceMeasures
{
  std::vector<double> angles; ///< TriangleMesh::angle() of each half-edge
  TriangleFrames frames;      ///< by triangle
};

SurfaceMeasures measureSurface(const TriangleMesh& mesh, const Execution& execution);

/// Measures any flattening of a mesh. Areas are signed as the positions are given: a map that
/// mirrors the whole surface counts as flipped everywhere, so mirror its positions first. A
/// triangle without area in space has areaRatio 0. \param edges half-edges whose length counts for
/// E_len.
FlatteningQuality measureFlattening(const TriangleMesh& mesh, const Points2& positions,
  const Indices& edges, const Execution& execution);
/// The same where the surface has been measured before.
FlatteningQuality measureFlattening(const TriangleMesh& mesh, const SurfaceMeasures& surface,
  const Points2& positions, const Indices& edges, const Execution& execution);

/// Those measures that tell a bad flattening from a good one, as in QualitySummary.
struct MapDistortion
{
  double globalHomogeneity = 0.0;
  double rigidEnergy = 0.0;
};

/// Without the angles and the quantile of the strain.
MapDistortion measureDistortion(
  const TriangleMesh& mesh, const Points2& positions, const Execution& execution);

/// Triangles that are turned over, or have no area.
Index countFlipped(const TriangleMesh& mesh, const Points2& positions);

/// Length of the cuts along which a surface has been opened: of its boundary edges that end at the
/// same places in space as another one, those of each place once.
double cutLength(const TriangleMesh& mesh);

/// E_dev of Eq. 25, in radians: size of the angle defect, 2 pi less the sum of the angles around
/// each interior vertex; 0 on the boundary, where any sum can lie flat.
/// \param angles TriangleMesh::angle() of each half-edge.
std::vector<double> surfaceDevelopability(
  const TriangleMesh& mesh, const std::vector<double>& angles);

/// TriangleMesh::angle() of each half-edge, in radians.
std::vector<double> cornerAngles(const TriangleMesh& mesh, const Execution& execution);
}
