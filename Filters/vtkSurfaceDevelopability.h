// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceDevelopability
 * @brief how far each point of a surface is from being developable
 *
 * Adds the point array `Developability` (double, radians) to the surface: abs(2 pi - sum of the
 * angles around the point), Eq. 25 of the WireWarping paper, which is 0 where the surface can be
 * laid flat without stretch; 0 also at points on the boundary, where any sum can lie flat, and at
 * points that no polygon uses. Regions of high values are where a dart or a feature curve helps.
 *
 * The input is vtkPolyData; polygons and strips are measured as triangulated. Points with equal
 * coordinates are one only where hardly any two triangles share a point, as in files of separate
 * triangles. Of ghost cells, copies of another process's count, so that values are right at its
 * border, and hidden ones do not. Cells and all other data pass through, but arrays that are too
 * short for their points or cells. After a refusal (see vtkFlatteningAlgorithm)
 * the output is without points and cells.
 *
 * @code
 * vtkNew<vtkSurfaceDevelopability> measured;
 * measured->SetInputData(surface);
 * measured->Update();
 * vtkDataArray* defect = measured->GetOutput()->GetPointData()->GetArray("Developability");
 * std::cout << "largest angle defect: " << defect->GetRange()[1] << " rad\n";
 * @endcode
 *
 * @warning The defect is that of one point: on a finer mesh of the same shape each is smaller.
 *
 * @sa vtkWireWarpingFilter
 */
#ifndef vtkSurfaceDevelopability_h
#define vtkSurfaceDevelopability_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatteningAlgorithm.h"

class VTKFILTERSFLATTENING_EXPORT vtkSurfaceDevelopability : public vtkFlatteningAlgorithm
{
public:
  static vtkSurfaceDevelopability* New();
  vtkTypeMacro(vtkSurfaceDevelopability, vtkFlatteningAlgorithm)

protected:
  vtkSurfaceDevelopability() = default;
  ~vtkSurfaceDevelopability() override = default;

  bool TakesParts() const override { return true; }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceDevelopability(const vtkSurfaceDevelopability&) = delete;
  void operator=(const vtkSurfaceDevelopability&) = delete;
};

#endif
