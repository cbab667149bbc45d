// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Sewing/SewingModel.h"

namespace flattening
{
/// How the flat pieces are tested.
enum class SewingTest
{
  /// Each piece on its own, its boundary held where the design has it: what the sewer's hand does
  /// with a panel that is eased into its place.
  Panel,
  /// All that is sewn together, seams shared and hems free.
  Product,
};

/// Pieces that hang together, ready to come to rest.
struct SewnShape
{
  SewnCloth cloth;
  Indices triangles; ///< of the cut surface
  Indices vertices;  ///< per vertex of the cloth the first of the cut surface that is sewn to it
  Index pieces = 0;
  bool sewn = false; ///< at one edge at least
};

struct SewnTopology
{
  std::vector<SewnShape> shapes;
  Indices shapeOfTriangle;
  Indices vertexInShape; ///< per vertex of the cut surface; none: in no triangle
};

/// Divides the cut surface into what comes to rest together: Panel its pieces, Product what is sewn
/// together.
/// \param positions in the plane, per vertex of the cut surface.
SewnTopology sewnShapes(const CutSurface& cut, const Points2& positions, SewingTest test);
}
