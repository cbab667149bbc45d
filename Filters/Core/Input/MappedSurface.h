// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

namespace flattening
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
MappedSurface loadMappedSurface(const DataSet& surface, const DataSet* flat, const DataSet* edges);
}
