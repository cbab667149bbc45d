// SPDX-License-Identifier: BSD-3-Clause
#include "PlainText.h"

#include <array>
#include <cstdint>

namespace wirewarp
{
namespace
{
constexpr std::uint32_t invalid = 0;

/// A character of UTF-8.
struct Character
{
  std::uint32_t code; ///< `invalid` where there is none
  std::size_t length; ///< in bytes
};

Character firstOf(std::string_view text)
{
  const auto byte = [&text](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const std::uint32_t first = byte(0);
  if (first < 0x80)
  {
    return { first, 1 };
  }
  const std::size_t length = first < 0xC2 ? 1
    : first < 0xE0                        ? 2
    : first < 0xF0                        ? 3
    : first < 0xF5                        ? 4
                                          : 1;
  if (length == 1 || length > text.size())
  {
    return { invalid, 1 };
  }
  std::uint32_t code = first & (0xFFu >> (length + 1));
  for (std::size_t k = 1; k < length; ++k)
  {
    if ((byte(k) & 0xC0u) != 0x80u)
    {
      return { invalid, 1 };
    }
    code = (code << 6) | (byte(k) & 0x3Fu);
  }
  static constexpr std::array<std::uint32_t, 5> least{ 0, 0, 0x80, 0x800, 0x10000 };
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < least[length] || code > 0x10FFFF || surrogate)
  {
    return { invalid, 1 };
  }
  return { code, length };
}

/// Neither a control character nor one that ends a line or turns the direction of writing, nor one
/// that XML forbids.
bool isPlain(std::uint32_t code)
{
  return code >= 0x20 && !(code >= 0x7F && code < 0xA0) && !(code >= 0x2028 && code <= 0x202E) &&
    !(code >= 0x2066 && code <= 0x2069) && code != 0xFFFE && code != 0xFFFF;
}
}

//------------------------------------------------------------------------------
std::string plainText(std::string_view text)
{
  std::string plain;
  while (!text.empty())
  {
    const Character first = firstOf(text);
    plain.append(isPlain(first.code) ? text.substr(0, first.length) : "?");
    text.remove_prefix(first.length);
  }
  return plain;
}
}
