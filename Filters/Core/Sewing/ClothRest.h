// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sewing/SewingModel.h"
#include "Sparse/NewtonKkt.h"

namespace flattening
{
/// When cloth is at rest.
struct RestOptions
{
  /// No force on a vertex, over modulus times the root of the mean triangle area, is larger, ...
  double forceTolerance = 1e-12;
  /// ... or a further step promises to lower the energy by no more than this fraction of it.
  double energyTolerance = 1e-9;
  int maximumIterations = 300;
  const char* phase = nullptr; ///< name in reports of progress; null: none are made
  std::function<void(const NewtonKktRecord&)> observe;
};

/// Goes from there to the minimum of the model next to it. A body pushes by a penalty first, and by
/// a barrier once no vertex is inside; where no penalty achieves that it stays with the last.
/// \param from per vertex of the cloth.
NewtonKktState bringToRest(
  SewingModel& model, const Points3& from, const RestOptions& options, const Execution& execution);
}
