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

    bool keeps(double bound) const { return this->sound && this->strain <= bound; }
  };

  /// \param maxSteps after which a flattening is given up
  ChartTrials(const FlatteningOptions& flattening, double maxSteps)
    : Flattening(flattening)
    , MostSteps(maxSteps)
  {
  }

  /// Sets of charts, in parallel. A set is no better than the worst of its charts, wastes as much
  /// as all of them, and is given up at the first that does not keep the bound. Those after the
  /// budget is spent are not tried.
  std::vector<Result> run(const std::vector<std::vector<TriangleMesh>>& sets, double bound,
    TrialBudget& budget, const Execution& execution);

private:
  using Key = std::array<std::uint64_t, 2>;

  static Key keyOf(const TriangleMesh& chart);
  /// \param most work, after which it is given up
  Result flattened(const TriangleMesh& chart, double most, const Execution& execution) const;

  FlatteningOptions Flattening;
  double MostSteps;
  std::map<Key, Result> Known;
};
}
