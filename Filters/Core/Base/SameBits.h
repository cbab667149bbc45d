// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <cstring>

namespace flattening
{
/// Whether points are the same to the last bit. Unlike == it tells signed zeros apart, and knows a
/// NaN again.
inline bool sameBits(const Points3& a, const Points3& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data()->data(), b.data()->data(), a.size() * sizeof(Point3)) == 0);
}
}
