// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceDevelopability
 * @brief how far each point of a surface is from being developable
 */
#ifndef vtkSurfaceDevelopability_h
#define vtkSurfaceDevelopability_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSFLATTENING_EXPORT vtkSurfaceDevelopability : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceDevelopability* New();
  vtkTypeMacro(vtkSurfaceDevelopability, vtkPolyDataAlgorithm)

protected:
  vtkSurfaceDevelopability() = default;
  ~vtkSurfaceDevelopability() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceDevelopability(const vtkSurfaceDevelopability&) = delete;
  void operator=(const vtkSurfaceDevelopability&) = delete;
};

#endif
