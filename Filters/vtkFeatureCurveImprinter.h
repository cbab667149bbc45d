// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveImprinter
 * @brief make curves on a surface edges of its mesh
 *
 * Points of a curve may lie anywhere on the surface, and segments may cross triangles. Between two
 * points a curve runs in the section of the surface with the plane through both points and the
 * surface's normal; within one triangle it is straight. Triangles that it crosses are split, so
 * that it becomes a chain of edges; inside each triangle of the input the parts are constrained
 * Delaunay. New points lie on old edges and in old triangles: the shape of the surface stays, the
 * old points keep their places, and the length of a curve is that of its polyline on the surface.
 * Curves that cross share a point. What comes nearer to a point or an edge than SnapTolerance moves
 * onto it, so that no slivers arise. Inputs and options: see vtkFeatureCurveAlgorithm. A surface
 * whose edges all curves follow comes out with the same triangles.
 *
 * **Output 0, the surface**: the triangles of the input in the order of its cells, behind them
 * those made by splitting, with its point data (interpolated at new points), cell and field data.
 * Cell array: `vtkOriginalCellIds` (id). Point array: `vtkOriginalPointIds` (id; -1 for a new
 * point). Field data: `RunStatus`, `RunStatusMessage` (string).
 *
 * **Output 1, the curves** as polylines over the points of output 0, in the order of
 * vtkFeatureCurveAlgorithm, with the cell arrays that all of their data sets have, and: `CurveType`
 * (int), `CurveName` (string), `KeyShape` (int), `LengthTolerance` (double), `CurveId` (id),
 * `RestLength` (double, unit of length), `vtkOriginalCellIds` (id; the first cell of the curve in
 * its data set). Point array, where a curve has one: `PlanarShape` (double, 2 components),
 * interpolated; at a point of several curves that of the last one. Both outputs can be given to
 * vtkWireWarpingFilter.
 *
 * A refused input leaves both outputs without points and cells. Codes beside those of the surface:
 * CURVE_TOO_SHORT, CURVE_POINT_OFF_SURFACE (with the points and their distance),
 * CURVE_LEAVES_SURFACE (a segment meets the boundary, or cannot be followed), CURVE_NOT_ON_EDGES
 * (with SplitTriangles off), INVALID_CURVE, NUMERICAL_FAILURE (triangles too thin to split).
 *
 * @code
 * vtkNew<vtkFeatureCurveImprinter> imprinter;
 * imprinter->SetInputData(surface);
 * imprinter->SetCurvesData(curves);
 * imprinter->Update();
 * vtkPolyData* finer = imprinter->GetOutput(0);
 * vtkPolyData* chains = imprinter->GetOutput(1); // over the points of finer
 * std::cout << finer->GetNumberOfCells() << " triangles, " << chains->GetNumberOfLines()
 *           << " curves on their edges\n";
 * @endcode
 *
 * @warning Normals that are interpolated at new points are not made unit again.
 *
 * @sa vtkFeatureCurveCutter vtkWireWarpingFilter
 */
#ifndef vtkFeatureCurveImprinter_h
#define vtkFeatureCurveImprinter_h

#include "vtkFeatureCurveAlgorithm.h"
#include "vtkFiltersFlatteningModule.h" // for the export macro

class VTKFILTERSFLATTENING_EXPORT vtkFeatureCurveImprinter : public vtkFeatureCurveAlgorithm
{
public:
  static vtkFeatureCurveImprinter* New();
  vtkTypeMacro(vtkFeatureCurveImprinter, vtkFeatureCurveAlgorithm)

protected:
  vtkFeatureCurveImprinter();
  ~vtkFeatureCurveImprinter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFeatureCurveImprinter(const vtkFeatureCurveImprinter&) = delete;
  void operator=(const vtkFeatureCurveImprinter&) = delete;
};

#endif
