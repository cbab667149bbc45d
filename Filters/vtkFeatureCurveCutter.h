// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveCutter
 * @brief cut a surface open along its darts and seams
 *
 * Points on darts and seams get one copy for each side, so that darts open and seams divide the
 * surface into pieces. A curve that ends on a cut stays with the copy on its own side. Inputs: see
 * vtkFeatureCurveAlgorithm.
 *
 * **Output 0, the cut surface**: the triangles of the input in the order of its cells, with its
 * point, cell and field data. Cell arrays: `PieceId` (id; connected components, in the order of
 * their first triangle), `vtkOriginalCellIds` (id). Point array: `vtkOriginalPointIds` (id; -1 for
 * a point made by imprinting). Field data: `SeamPairs` (id, 5 components; see
 * vtkFlatPieceAlgorithm; component 4 is the id of the curve), `RunStatus`, `RunStatusMessage`
 * (string).
 *
 * **Output 1, the wires** (boundary and curves; a cut curve has both of its sides) as polylines
 * over the points of output 0. Cell arrays: `CurveType` (int; -1 for the boundary), `CurveId` (id;
 * -1), `CurveName` (string), `PieceId` (id), `Boundary` (unsigned char, 1 where the wire bounds its
 * piece), `RestLength` (double, unit of length).
 *
 * A refused input leaves both outputs without points and cells.
 *
 * @code
 * vtkNew<vtkFeatureCurveCutter> cutter;
 * cutter->SetInputData(surface);
 * cutter->SetCurvesData(curves); // darts and seams among them are cut
 * cutter->Update();
 * vtkPolyData* cut = cutter->GetOutput();
 * if (vtkDataArray* pairs = cut->GetFieldData()->GetArray("SeamPairs"))
 * {
 *   std::cout << pairs->GetNumberOfTuples() << " pairs of edges to sew\n";
 * }
 * @endcode
 *
 * @warning Ids of points and cells are not those of the input; `vtkOriginalPointIds` and
 * `vtkOriginalCellIds` lead back.
 *
 * @sa vtkWireWarpingFilter
 */
#ifndef vtkFeatureCurveCutter_h
#define vtkFeatureCurveCutter_h

#include "vtkFeatureCurveAlgorithm.h"
#include "vtkFiltersFlatteningModule.h" // for the export macro

class VTKFILTERSFLATTENING_EXPORT vtkFeatureCurveCutter : public vtkFeatureCurveAlgorithm
{
public:
  static vtkFeatureCurveCutter* New();
  vtkTypeMacro(vtkFeatureCurveCutter, vtkFeatureCurveAlgorithm)

protected:
  vtkFeatureCurveCutter();
  ~vtkFeatureCurveCutter() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFeatureCurveCutter(const vtkFeatureCurveCutter&) = delete;
  void operator=(const vtkFeatureCurveCutter&) = delete;
};

#endif
