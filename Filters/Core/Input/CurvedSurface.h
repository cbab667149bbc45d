// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Input/InputSurface.h"
#include "Surface/FeatureCurve.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace flattening
{
/// Feature curves of one or several data sets, each a source with a number.
struct CurveInput
{
  std::vector<Polyline> polylines;          ///< pointIds: of the source that holds the curve
  std::vector<std::int64_t> cellOfPolyline; ///< its first cell there
  std::vector<int> sourceOfPolyline;
  std::vector<std::string> warnings; ///< of arrays that are not read
  Status outcome;
  int blamed = -1; ///< the source that is to blame where the outcome is not Ok
};

/// A surface with its feature curves imprinted, and the way back from Core's ids to the input's:
///
///     vertex of the cut surface -> CutSurface::originalVertex -> vertex of imprinted.mesh
///       -> imprinted.vertexSource -> vertex of surface.prepared.mesh -> originalPoint -> point of the input
///     triangle of the cut surface -> CutSurface::originalTriangle() -> triangle of imprinted.mesh
///       -> imprinted.originalTriangle -> triangle of the input -> cellOfTriangle -> cell of the input
///
/// What the ids of a Status are of, they know (ElementKind). Their numbering is that of the stage:
/// the input's where it is read; triangles and points of the input in
/// prepareSurface(); triangles of the input and points of the curve's source in imprintCurves();
/// vertices and triangles of imprinted.mesh after it; curves in the order of reading.
struct CurvedSurface
{
  std::vector<std::string> warnings; ///< what of the input is left out
  LoadedSurface surface;
  CurveInput curves;
  ImprintedSurface imprinted;
  Status outcome;
  int blamed = -1; ///< the source of the curve that is to blame

  /// How `curves` were imprinted on `surface`; none where they have not been.
  std::optional<ImprintOptions> imprintedBy;

  /// Cell of the input that a triangle of the imprinted surface is a part of.
  std::int64_t cellOf(Index triangle) const;
  /// Point of the input that a vertex of the imprinted surface is; -1 where imprinting made it.
  std::int64_t pointOf(Index vertex) const;
  /// Vertex of the imprinted surface that a point of the input became; none where no triangle uses
  /// it.
  Index vertexOf(std::int64_t point) const;
  /// The vertices of two points of the input; none for -1. Refuses points that no triangle uses,
  /// one pin alone, and twice the same.
  Status pinVertices(const std::array<std::int64_t, 2>& points, std::array<Index, 2>& pins) const;
  /// The outcome of a stage after imprinting. \param cut where its triangles are those of a cut
  /// surface that may lack some; null: those of the imprinted surface
  Status outcomeOfStage(const Status& status, const CutSurface* cut = nullptr) const;
};

/// The refusal of a curve of the input for what it says of itself.
Status refuseCurve(std::int64_t cell, const std::string& what, const char* suggested);

/// Refuses length tolerances outside [0, 1).
Status checkTolerance(std::int64_t cell, double tolerance);

/// Gives a key curve its shape in the plane, NaN for points without one. Refuses one of a part of
/// the points.
Status takePlanarShape(const Points2& shape, Polyline& curve);

/// Imprints curves that were read on the surface of the source, unless it has been done with the
/// same points.
void imprintInput(CurveInput read, const ImprintOptions& options, const Execution& execution,
  CurvedSurface& source);

/// The refusal of a name that no curve has.
Status noCurveNamed(const std::string& name, const CurvedSurface& source);

/// What the boundary beside all curves is called.
constexpr const char* boundaryName = "boundary";

/// Gives the curves of each name their length tolerance; that of the boundary is an option of the
/// flattening. InvalidOption where no curve has the name, or the tolerance lies outside [0, 1).
Status applyTolerances(const std::map<std::string, double>& tolerances, CurvedSurface& source);

/// A sentence for each dart or seam that stops one edge short of the boundary, with the point of
/// the input to begin it at.
std::vector<std::string> describeShortEnds(const CurvedSurface& source);
}
