// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SurfaceInput.h"

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// A surface and flat positions of its vertices, cut open as it is.
struct MappedSurface
{
  LoadedSurface surface;
  Points2 positions;     ///< per vertex
  bool mirrored = false; ///< the positions given turn the surface over; x has been negated
  Indices edges;         ///< half-edges whose length counts
  Status outcome;
};

/// \param flat the flat surface; null: the surface's texture coordinates
/// \param edges lines along the edges that count; null: the boundary
MappedSurface loadMappedSurface(vtkPolyData* surface, vtkPolyData* flat, vtkPolyData* edges);
}
}
