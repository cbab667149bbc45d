// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "AttributeArrays.h"
#include "CurveInput.h"
#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "SurfaceInput.h"
#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <optional>
#include <string>

namespace flattening
{
namespace bridge
{
/// What a surface was read from: the parts of a data set, which several data sets may share, and
/// its time, which is that of the part that was modified last.
class SurfaceOrigin
{
public:
  /// Nothing: no data is the same.
  SurfaceOrigin() = default;
  explicit SurfaceOrigin(vtkPolyData* data);

  /// Whether the data has the same parts, and none was modified in between.
  bool sameAs(const SurfaceOrigin& other) const;

private:
  vtkMTimeType Time = 0;
  vtkWeakPointer<vtkPoints> Points;
  std::array<vtkWeakPointer<vtkCellArray>, 4> Cells; ///< verts and lines count in cell ids
  vtkWeakPointer<vtkAbstractArray> Ghosts;
};

/// A surface with its feature curves imprinted, and the way back from Core's ids to the input's:
///
///     vertex of the cut surface -> CutSurface::originalVertex -> vertex of imprinted.mesh
///       -> imprinted.vertexSource -> vertex of surface.prepared.mesh -> originalPoint -> point of the input
///     triangle of the cut surface -> CutSurface::originalTriangle() -> triangle of imprinted.mesh
///       -> imprinted.originalTriangle -> triangle of the input -> cellOfTriangle -> cell of the input
///
/// What the ids of a Status are of, they know (ElementKind). Their numbering is that of the stage:
/// the input's in readTriangles() and readCurves(); triangles and points of the input in
/// prepareSurface(); triangles of the input and points of the curve's data set in imprintCurves();
/// vertices and triangles of imprinted.mesh after it; curves in the order of reading.
struct CurvedSurface
{
  vtkPolyData* data = nullptr; ///< the input, of this run only
  /// Arrays of the input that have a value for each point or cell.
  vtkSmartPointer<vtkPointData> pointArrays;
  vtkSmartPointer<vtkCellData> cellArrays;
  vtkSmartPointer<vtkFieldData> fieldData;
  std::vector<std::string> warnings; ///< what of the input is left out
  LoadedSurface surface;
  CurveInput curves;
  ImprintedSurface imprinted;
  Status outcome;
  vtkPolyData* blamed = nullptr; ///< the data set of the curve that is to blame

  /// Of the data that `surface` was loaded from.
  SurfaceOrigin origin;
  CoincidentPoints coincident = CoincidentPoints::Automatic;
  Defects defects = Defects::Heal;
  /// How `curves` were imprinted on `surface`; none where they have not been.
  std::optional<ImprintOptions> imprintedBy;

  /// Cell of the input that a triangle of the imprinted surface is a part of.
  vtkIdType cellOf(Index triangle) const;
  /// Point of the input that a vertex of the imprinted surface is; -1 where imprinting made it.
  vtkIdType pointOf(Index vertex) const;
  /// Vertex of the imprinted surface that a point of the input became; none where no triangle uses
  /// it.
  Index vertexOf(vtkIdType point) const;
  /// The vertices of two points of the input; none for -1. Refuses points that no triangle uses,
  /// one pin alone, and twice the same.
  Status pinVertices(const vtkIdType points[2], std::array<Index, 2>& pins) const;
  /// The outcome of a stage after imprinting. \param cut where its triangles are those of a cut
  /// surface that may lack some; null: those of the imprinted surface
  Status outcomeOfStage(const Status& status, const CutSurface* cut = nullptr) const;
};

/// Loads the surface with its curves. What the source holds of a run before is taken over where it
/// is made from the same: the surface and, where the points of the curves are the same, the
/// imprint.
void loadCurvedSurface(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves,
  CoincidentPoints coincident, Defects defects, const ImprintOptions& options,
  const Execution& execution, CurvedSurface& source);

/// The refusal of a name that no curve has.
Status noCurveNamed(const std::string& name, const CurvedSurface& source);

/// Gives the curves of each name their length tolerance. InvalidOption where no curve has the name,
/// or the tolerance lies outside [0, 1).
Status applyTolerances(const std::map<std::string, double>& tolerances, CurvedSurface& source);

/// A sentence for each dart or seam that stops one edge short of the boundary, with the point of
/// the input to begin it at.
std::vector<std::string> describeShortEnds(const CurvedSurface& source);
}
}
