// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"
#include "Flattening/SurfaceFlattening.h"

#include <memory>

namespace flattening
{
namespace bridge
{
/// What a filter keeps from one run to the next.
struct KeptRun
{
  std::shared_ptr<CurvedSurface> source;
  FlatteningCache pieces;
};
}
}
