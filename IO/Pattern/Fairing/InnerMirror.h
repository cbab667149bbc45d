// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/OutlineMirror.h"

#include <string>

namespace flattening
{
namespace pattern
{
/// Adds the stretches within a piece that are mirror images of each other, or of themselves, to a
/// mirror that was found for its outline: those of holes and curves whose points are so to
/// mirrorTolerance, and their lengths to mirroredLengthTolerance.
void findInnerMirror(const DrawingSource& all, const BorderChains& chains,
  const std::vector<PlannedChain>& plan, OutlineMirror& mirror);

/// How curves within a symmetric piece, and the borders of its holes, are drawn: those whose points
/// are mirror images of other such points, to mirrorTolerance, or of their own.
struct InnerMirror
{
  std::size_t curves = 0; ///< that have an image
  double miss = 0.0;      ///< of what is drawn from the mirror image of what is drawn, millimetres
  std::string worst;      ///< the curve that misses most
};

/// Measures them along what is drawn.
/// \param spans of each chain, along it
/// \param outline the chain that is the outline of the piece
InnerMirror measureInnerMirror(const DrawingSource& all, const BorderChains& chains,
  const std::vector<std::vector<FairSpan>>& spans, std::size_t outline, const MirrorAxis& axis);
}
}
