// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Editing/DrawingSurface.h"
#include "Surface/FeatureCurve.h"

namespace flattening
{
namespace bridge
{
/// Remembers which of several curves lies farthest from a surface.
class FarthestCurve
{
public:
  /// The surface must outlive it.
  explicit FarthestCurve(const DrawingSurface& surface);

  /// \pre The points are finite.
  void offer(const Polyline& line);
  /// Words on it; empty where it is on the surface as the filters' default has it.
  std::string note() const;

private:
  const DrawingSurface& Surface;
  double Distance = 0.0;
  std::string Name;
};
}
}
