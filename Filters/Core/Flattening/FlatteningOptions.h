// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolver.h"
#include "Embedding/ConformalMap.h"
#include "Embedding/InteriorEmbedding.h"
#include "Isometric/IsometricWarping.h"

namespace flattening
{
enum class Scheme
{
  Progressive, ///< patch by patch, Algorithm 2
  Global,      ///< all patches together, Eq. 13
  Isometric,   ///< wires and interior together
  Conformal,   ///< LSCM, for comparison: keeps no length
};

/// All defaults of the project are these and those of the options inside: filters, command, Python
/// package and plugin take them over or are tested for it.
struct FlatteningOptions
{
  Scheme scheme = Scheme::Isometric;
  AngleSolverOptions angles;
  InteriorOptions interior;
  IsometricOptions isometric;
  ConformalOptions conformal; ///< pins are vertices of the surface before the cut
  /// Close cuts as far as their banks would lie over each other (see closeCrossingCuts()).
  bool closeCuts = false;
  /// Leave out pieces without boundary or with handles instead of refusing the surface for them.
  bool skipClosed = false;
  /// Treat key curves as accessory curves.
  bool releaseKeys = false;
  /// Try what the advice on releases promises, which takes up to six flattenings of a piece that
  /// lies poorly (see adviseByTrials()); otherwise curves are ranked by their sensitivity alone.
  bool tryReleases = true;
  /// Lay the pieces beside each other, each upright (see arrangePieces()); otherwise each stays
  /// where its first wire edge put it.
  bool arrange = true;
  /// Space between the bounding boxes of arranged pieces, as a fraction of the largest side of one,
  /// 0 to 1e6.
  double spacing = 0.05;
  /// A wire edge whose relative length error is larger breaks the promise.
  double lengthTolerance = 1e-9;
};
}
