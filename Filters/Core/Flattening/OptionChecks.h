// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Flattening/FlatteningOptions.h"

namespace flattening
{
/// InvalidOption where a number of the options lies outside its range or the material is unknown or
/// without meaning; numbers of the interior are checked where it is placed.
Status checkOptions(const FlatteningOptions& options);
}
