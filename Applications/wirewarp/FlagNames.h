// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace wirewarp
{
/// A message of the filter, in whose ways out the command's options stand in place of the words of
/// the library.
std::string withFlags(std::string message);
}
