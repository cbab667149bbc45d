// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Wires/WireNetwork.h"

namespace flattening
{
/// Places all wire vertices in the plane by the planar angles (Eqs. 3 and 8): along a spanning
/// tree, what is left is spread by least squares over all edges, then minimum-norm Newton steps
/// make the lengths exact. The result does not depend on a seed patch.
/// \param length per wire edge. \return per piece vertex; those that no wire runs through are zero
Points2 layOutWires(
  const WireNetwork& network, const std::vector<double>& theta, const std::vector<double>& length);

/// Makes the length of every wire edge exact by minimum-norm Newton steps from positions where it
/// is nearly so. \param positions per piece vertex; only host vertices move.
void correctWireLengths(
  const WireNetwork& network, const std::vector<double>& length, Points2& positions);
}
