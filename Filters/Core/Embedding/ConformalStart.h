// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleProblem.h"
#include "Base/Execution.h"

namespace flattening
{
/// Angles and lengths of the wires in a least squares conformal map of the piece, to start from
/// where the plain start fails; those on the surface where there is no such map.
AngleStart conformalStart(
  const Piece& piece, const WireNetwork& network, const Execution& execution);
}
