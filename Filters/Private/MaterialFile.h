// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cloth/ClothMaterial.h"

namespace flattening
{
namespace bridge
{
/// Whether the text names a file rather than a material.
bool isMaterialFile(const std::string& text);

/// A material from a JSON file, as Documentation/materials.md has it. Its status says what is wrong
/// with the file.
ClothMaterial readMaterialFile(const std::string& path);
}
}
