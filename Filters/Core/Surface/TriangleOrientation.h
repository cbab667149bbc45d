// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Base/Types.h"

namespace flattening
{
/// Pairs the half-edges of any triangles and turns over those that run against the majority of
/// their component.
/// \param pointIds what to call each vertex in messages. \param partner of each half-edge, before a
/// triangle is turned over. \param reversed the triangles that were, ascending.
/// Errors (ids: triangles): NonManifoldEdge, NotOrientable.
Status orientTriangles(
  const Indices& pointIds, Triangles& triangles, Indices& partner, Indices& reversed);
}
