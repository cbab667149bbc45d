// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace wirewarp
{
/// A text as one line of sound UTF-8 that a terminal and XML can take: each control character and
/// each byte that is no UTF-8 becomes a question mark. Names in files may hold what would color,
/// move or overwrite what stands on the screen.
std::string plainText(std::string_view text);

/// The line of an error, a warning or a note, which is the kind.
std::string messageLine(std::string_view kind, std::string_view text);
}
