// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Whether the plane has room for a surface, without flattening anything.
struct AreaForecast
{
  /// Part of the area that is lost where the boundary keeps its lengths: 1 - int exp(-2 u) / int 1,
  /// u the scale factor (see ScaleFactor). Exact for smooth conformal maps; any other map that
  /// folds nothing has to lose about as much. 0 where it is less than `noticeable`.
  double loss = 0.0;
  /// An example of a cut that gives room: vertices along edges from the boundary to where the
  /// surface is deepest. Empty where there is nothing to say.
  Indices cut;
  double lossAfterCut = 0.0;
  /// Cuts that open a tube: vertices along edges, each from one boundary loop to another. They lead
  /// to the loops that no plane can hold as holes, since a narrow ring around one loses
  /// `noticeable` of its width there or more. Empty: none is such.
  std::vector<Indices> openings;
  /// False where a run was cancelled on the way, or a system could not be solved.
  bool known = false;

  /// From here on no seamstress calls it ease.
  static constexpr double noticeable = 0.3;
  bool deep() const { return this->loss >= noticeable; }
  bool tube() const { return !this->openings.empty(); }
};

/// One linear system, a second one where the surface is deep, and none where it is plain from the
/// angle defects that it is not.
AreaForecast forecastArea(const TriangleMesh& mesh, const Execution& execution);
}
