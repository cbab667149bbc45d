// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Wires/WireNetwork.h"

namespace flattening
{
struct WireLayout
{
  /// Per piece vertex; only those of host vertices are set, the others are zero.
  Points2 positions;
  /// Largest relative error of a wire edge's length.
  double maximumLengthError = 0.0;
};

/// Places all wire vertices in the plane by the planar angles (Eqs. 3 and 8): along a spanning
/// tree, what is left is spread by least squares over all edges, then minimum-norm Newton steps
/// make the lengths exact. The result does not depend on a seed patch.
/// \param length per wire edge.
WireLayout layOutWires(
  const WireNetwork& network, const std::vector<double>& theta, const std::vector<double>& length);

/// Makes the length of every wire edge exact by minimum-norm Newton steps from positions where it
/// is nearly so. \param positions per piece vertex; only host vertices move. \return the largest
/// relative error that is left.
double correctWireLengths(
  const WireNetwork& network, const std::vector<double>& length, Points2& positions);
}
