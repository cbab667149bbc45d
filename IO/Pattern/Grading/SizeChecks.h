// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Grading/SizeGrading.h"

#include <cstddef>

namespace flattening
{
namespace pattern
{
/// Whether sizes can be graded. \param base the place of the base size among them, which is found
/// \return the errors of gradeSizes()
Status checkSizes(
  const std::vector<PatternSize>& sizes, const GradingOptions& options, std::size_t& base);
}
}
