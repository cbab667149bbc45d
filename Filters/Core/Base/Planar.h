// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

namespace flattening
{
/// The cross product of two vectors of the plane: the area that they span, positive where v lies to
/// the left of u.
inline double cross(const Point2& u, const Point2& v)
{
  return u.x() * v.y() - u.y() * v.x();
}
}
