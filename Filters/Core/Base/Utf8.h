// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace flattening
{
/// Takes a character of UTF-8 off the front of a text that is not empty.
/// \return its code point; none where there is none, and a byte was taken
std::optional<std::uint32_t> takeCharacter(std::string_view& text);
}
