// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace wirewarp
{
/// What replaces an option of the time before there were commands; empty: it is none of these.
std::string successorOf(const std::string& option);
}
