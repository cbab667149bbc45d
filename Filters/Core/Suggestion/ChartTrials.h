// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutTrials.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>

namespace flattening
{
/// Flattens charts, each once: what is known of one costs nothing when it comes again with the same
/// points and triangles.
class ChartTrials
{
public:
  struct Result
  {
    bool sound = false; ///< laid flat without folds and overlaps
    double strain = std::numeric_limits<double>::infinity(); ///< on 95 % of the area
    double waste = 0.0;                                      ///< see TrialOutcome
    double work = 0.0;
    /// The bound that the first part did not keep; 0 where the piece was flattened.
    double upTo = 0.0;
    std::vector<FlatCorners>
      corners; ///< by triangle of the last chart; in parts, where it is sound

    /// Whether it tells as much of another bound.
    bool holdsFor(double bound) const { return this->upTo == 0.0 || bound <= this->upTo; }
    bool keeps(double bound) const { return this->sound && this->strain <= bound; }
  };

  /// \param maxSteps after which a flattening is given up \param inParts whether overlaps are
  /// prevented from the start on, and only what keeps the bound so is flattened as the piece will
  /// be
  ChartTrials(const FlatteningOptions& flattening, double maxSteps, bool inParts = false)
    : Flattening(flattening)
    , MostSteps(maxSteps)
    , InParts(inParts && flattening.preventOverlap)
  {
  }

  /// Sets of charts, in parallel. A set is no better than the worst of its charts, wastes as much
  /// as all of them, and is given up at the first that does not keep the bound. Those after the
  /// budget is spent are not tried. In parts, a strain above the bound is no minimum's.
  /// \param start by triangle of each chart, where it may lie; empty for none
  std::vector<Result> run(const std::vector<std::vector<TriangleMesh>>& sets, double bound,
    TrialBudget& budget, const Execution& execution, const std::vector<FlatCorners>& start = {});

private:
  using Key = std::array<std::uint64_t, 2>;

  static Key keyOf(const TriangleMesh& chart);
  /// \param most work, after which it is given up
  Result flattened(const TriangleMesh& chart, double bound, double most,
    const std::vector<FlatCorners>& start, const Execution& execution) const;

  FlatteningOptions Flattening;
  double MostSteps;
  bool InParts;
  std::map<Key, Result> Known;
};
}
