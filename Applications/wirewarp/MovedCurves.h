// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace wirewarp
{
/// How far the points of the curves lie off the surface at most, in its unit: by so much they are
/// moved to be laid on it. Curves over the surface's own points lie on it.
double largestDistance(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves);

/// Throws InputError where the cells of a surface have other corners than those of the base.
void checkConnectivity(
  vtkPolyData* base, const std::string& basePath, vtkPolyData* surface, const std::string& path);

/// Curves of one surface on another of the same connectivity: each point at the same place of the
/// same cell, those over the surface's own points at the same points.
vtkSmartPointer<vtkPolyData> movedCurves(vtkPolyData* curves, vtkPolyData* from, vtkPolyData* to);

/// A note where curves over the surface's own vertices have numbers as their names, which may be
/// vertices of lines without a name; empty where none has.
std::string notesOfNumberNames(vtkPolyData* surface, vtkPolyData* curves);
}
