// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Utf8.h"

#include <array>
#include <cstddef>

namespace flattening
{
std::optional<std::uint32_t> takeCharacter(std::string_view& text)
{
  const std::string_view whole = text;
  const auto byte = [whole](std::size_t k) { return static_cast<unsigned char>(whole[k]); };
  text.remove_prefix(1);
  const std::uint32_t first = byte(0);
  if (first < 0x80)
  {
    return first;
  }
  const std::size_t length = first < 0xC2 ? 1
    : first < 0xE0                        ? 2
    : first < 0xF0                        ? 3
    : first < 0xF5                        ? 4
                                          : 1;
  if (length == 1 || length > whole.size())
  {
    return std::nullopt;
  }
  std::uint32_t code = first & (0xFFu >> (length + 1));
  for (std::size_t k = 1; k < length; ++k)
  {
    if ((byte(k) & 0xC0u) != 0x80u)
    {
      return std::nullopt;
    }
    code = (code << 6) | (byte(k) & 0x3Fu);
  }
  static constexpr std::array<std::uint32_t, 5> least{ 0, 0, 0x80, 0x800, 0x10000 };
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < least[length] || code > 0x10FFFF || surrogate)
  {
    return std::nullopt;
  }
  text = whole.substr(length);
  return code;
}
}
