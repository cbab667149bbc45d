// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"

#include <string>
#include <vector>

namespace flattening
{
/// What vtkFlatPieceAlgorithm's Material and its grain say. A material that cannot be read has a
/// status that says why.
ClothOptions readCloth(const std::string& material, const std::vector<std::string>& grain = {});
}
