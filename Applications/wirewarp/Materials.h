// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>

namespace wirewarp
{
/// The materials that --material knows by name: a table, then the sources of the numbers.
void printMaterials(std::ostream& out);
}
