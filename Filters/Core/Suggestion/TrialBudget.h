// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutTrials.h"

#include <vector>

namespace flattening
{
/// What a search may spend on flattenings. Their work is counted, not timed, so that a search that
/// is ended by it has the same result wherever it is made.
class TrialBudget
{
public:
  /// \param most as TrialOutcome::work counts it
  explicit TrialBudget(double most)
    : Most(most)
  {
  }

  bool spent() const { return this->Paid >= this->Most; }
  double most() const { return this->Most; }
  /// Paid so far.
  double work() const { return this->Paid; }
  Index trials() const { return this->Trials; }

  void pay(const TrialOutcome& outcome)
  {
    this->Paid += outcome.work;
    ++this->Trials;
  }
  void pay(const std::vector<TrialOutcome>& outcomes)
  {
    for (const TrialOutcome& outcome : outcomes)
    {
      this->pay(outcome);
    }
  }

private:
  double Most;
  double Paid = 0.0;
  Index Trials = 0;
};
}
