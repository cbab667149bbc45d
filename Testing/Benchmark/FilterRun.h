// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RefinedPiece.h"

#include <vtkNew.h>
#include <vtkWireWarpingFilter.h>

namespace benchmarks
{
/// The filter on a surface with curves, global scheme.
class FilterRun
{
public:
  /// \param interior one of the filter's; \param caching whether it keeps what the surface gives.
  FilterRun(const RefinedPiece& piece, int interior, bool caching);

  /// Runs it anew on one thread, as after a change of an option. Throws std::runtime_error where it
  /// refuses.
  void update();
  /// Seconds of the processor that the last Update() took beyond Core.
  double overheadSeconds() const { return this->Overhead; }
  double coreSeconds() const { return this->Core; }

private:
  vtkNew<vtkWireWarpingFilter> Filter;
  double Overhead = 0.0;
  double Core = 0.0;
};
}
