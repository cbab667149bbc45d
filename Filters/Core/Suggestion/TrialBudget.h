// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

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
  double left() const { return this->Most - this->Paid; }
  /// Paid so far.
  double work() const { return this->Paid; }
  Index trials() const { return this->Trials; }

  void pay(double work)
  {
    this->Paid += work;
    ++this->Trials;
  }
  /// What another paid.
  void add(const TrialBudget& other)
  {
    this->Paid += other.Paid;
    this->Trials += other.Trials;
  }

private:
  double Most;
  double Paid = 0.0;
  Index Trials = 0;
};
}
