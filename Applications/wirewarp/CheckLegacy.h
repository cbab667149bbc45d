// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace wirewarp
{
/// Makes sure that a legacy VTK file holds the points and cells that it announces, because VTK's
/// reader crashes on one that does not. What follows the cells is left to VTK's reader. Throws
/// InputError.
/// \param bytes of the whole file; \param path for messages.
void checkLegacyPolyData(const std::string& path, std::string_view bytes);
}
