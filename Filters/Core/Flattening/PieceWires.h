// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Angles/AngleSolver.h"
#include "Angles/ReleaseAdvice.h"
#include "Flattening/FlatteningOptions.h"

#include <functional>

namespace flattening
{
/// The wires' problem as it was solved in the end, and its solution.
struct WireSolution
{
  AngleProblem problem;
  AngleSolution angles;
  Indices warpingOrder; ///< wire-patches, where they are warped progressively
  Indices released;     ///< key curves whose shape was given up
  Status status;        ///< of the angles, or IncompatibleKeys with the released curves
};

/// Solves the planar angles of one piece's wires by the scheme of the options. Only refers to what
/// it is made from.
class PieceWires
{
public:
  using Acceptance = std::function<bool(const WireSolution&)>;

  PieceWires(const Piece& piece, const WireNetwork& network, const CutSurface& cut,
    const std::vector<FeatureCurve>& curves, const FlatteningOptions& options,
    const Execution& execution);

  /// With the key curves locked unless the options release them. Where their shapes contradict each
  /// other the least set is released (see releaseKeys()).
  WireSolution solve() const;
  /// Releases the least set of key curves with which the solution is accepted. \return the failed
  /// solution where none is.
  WireSolution release(WireSolution failed, const Acceptance& accepts) const;
  /// Which curves to release for smaller changes of angles. \param poor whether the piece lies
  /// badly; so it does anyway where angles change by much.
  ReleaseAdvice advise(const WireSolution& wires, bool poor) const;

private:
  WireSolution solveFor(const NodeLocks& locks) const;
  void warpPatches(WireSolution& wires) const;

  const Piece& Subject;
  const WireNetwork& Network;
  const CutSurface& Cut;
  const std::vector<FeatureCurve>& Curves;
  const FlatteningOptions& Options;
  const Execution& Execute;
};
}
