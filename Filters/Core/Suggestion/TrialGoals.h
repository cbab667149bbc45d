// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningResult.h"

namespace flattening
{
/// By piece, the integral of the strain's fourth power. \param counted area of each triangle
std::vector<double> peakStrains(const FlatteningResult& flat, const std::vector<double>& counted);

/// By piece, the integral of the change of area. \param counted area of each triangle
std::vector<double> areaChanges(const FlatteningResult& flat, const std::vector<double>& counted);

/// The middle of the triangle that is strained most of those that count.
Point3 worstPlace(const FlatteningResult& flat, const std::vector<double>& counted);
}
