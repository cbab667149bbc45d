// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"

#include <nlohmann/json.hpp>

namespace wirewarp
{
/// The proposed cuts or lines, in the order of choice.
nlohmann::ordered_json suggestionReports(const Flattening& result);
nlohmann::ordered_json leftOutLineReports(const Flattening& result);
/// What proposals keep to: a plane by its normal and offset, or an axis by its ends; null without.
nlohmann::ordered_json mirrorReport(const Flattening& result);
}
