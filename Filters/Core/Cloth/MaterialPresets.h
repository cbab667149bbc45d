// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothMaterial.h"

#include <optional>
#include <vector>

namespace flattening
{
/// Materials by name, each with the source of its numbers. Measured ones are of one cloth each;
/// another of the same name may differ by half, and shear over thread stiffness, which decides the
/// flat shape, by less.
const std::vector<ClothMaterial>& materialPresets();

/// No value where none has the name; capitals count as small letters.
std::optional<ClothMaterial> findPreset(const std::string& name);

/// The names, for messages: "isotropic, plain, ...".
std::string presetNames();
}
