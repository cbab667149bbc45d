// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SurfaceFlattening.h"
#include "SurfaceInput.h"

#include "vtkType.h"

namespace flattening
{
namespace bridge
{
/// What a filter keeps from one run to the next.
struct KeptRun
{
  /// Of the input that `surface` was loaded from; times are unique among all objects. 0: none.
  vtkMTimeType surfaceTime = 0;
  CoincidentPoints coincident = CoincidentPoints::Automatic;
  LoadedSurface surface;
  FlatteningCache factors;
};
}
}
