// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Imprint/ImprintedSurface.h"

namespace flattening
{
/// What a flattening with some cuts turned out to be.
struct TrialOutcome
{
  bool valid = false;     ///< there is a flattening, and no cut touches a key curve inside
  double energy = 0.0;    ///< rigid energy times area, over all pieces
  double strainP95 = 0.0; ///< of the piece where it is largest
  double areaError = 0.0; ///< mean over the pieces by area
  std::size_t flipped = 0;
  std::size_t overlaps = 0;
  std::vector<Points3> paths; ///< by cut: its vertices on the surface
  std::vector<double> lengths;
  /// By piece, in the order of their smallest triangles.
  std::vector<double> pieceStrains;
  std::vector<double> pieceEnergies;

  double cutLength() const;
  int severity = 0; ///< of its status
  /// No promise is broken worse than before: nothing more is folded or lies over another part.
  bool soundAfter(const TrialOutcome& before) const
  {
    return this->valid && this->severity <= before.severity && this->flipped <= before.flipped &&
      this->overlaps <= before.overlaps;
  }
};

/// Flattens one surface with the curves that it has anyway and with cuts on trial.
class CutTrials
{
public:
  /// The mesh must outlive it.
  CutTrials(const TriangleMesh& mesh, std::vector<Polyline> curves, const ImprintOptions& imprint,
    const FlatteningOptions& flattening);

  TrialOutcome run(const std::vector<Polyline>& cuts, const Execution& execution) const;
  /// Several, in parallel; an empty set of cuts is not tried.
  std::vector<TrialOutcome> runAll(
    const std::vector<std::vector<Polyline>>& cuts, const Execution& execution) const;
  const std::vector<Polyline>& curves() const { return this->Curves; }

private:
  const TriangleMesh& Mesh;
  std::vector<Polyline> Curves;
  ImprintOptions Imprint;
  FlatteningOptions Flattening;
};
}
