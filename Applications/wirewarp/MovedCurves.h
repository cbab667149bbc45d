// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace wirewarp
{
/// Throws InputError where the cells of a surface have other corners than those of the base.
void checkConnectivity(
  vtkPolyData* base, const std::string& basePath, vtkPolyData* surface, const std::string& path);

/// Curves of one surface on another of the same connectivity: each point at the same place of the
/// same cell, those over the surface's own points at the same points.
vtkSmartPointer<vtkPolyData> movedCurves(vtkPolyData* curves, vtkPolyData* from, vtkPolyData* to);
}
