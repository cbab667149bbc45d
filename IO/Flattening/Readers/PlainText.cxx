// SPDX-License-Identifier: BSD-3-Clause
#include "PlainText.h"

#include "Base/Utf8.h"

#include <cstdint>
#include <optional>

namespace wirewarp
{
namespace
{
/// Neither a control character nor one that ends a line or turns the direction of writing, nor one
/// that XML forbids.
bool isPlain(std::uint32_t code)
{
  return code >= 0x20 && !(code >= 0x7F && code < 0xA0) && !(code >= 0x2028 && code <= 0x202E) &&
    !(code >= 0x2066 && code <= 0x2069) && code != 0xFFFE && code != 0xFFFF;
}
}

std::string plainText(std::string_view text)
{
  std::string plain;
  while (!text.empty())
  {
    const std::string_view before = text;
    const std::optional<std::uint32_t> code = flattening::takeCharacter(text);
    plain.append(code && isPlain(*code) ? before.substr(0, before.size() - text.size()) : "?");
  }
  return plain;
}

std::string messageLine(std::string_view kind, std::string_view text)
{
  return std::string("wirewarp: ").append(kind).append(": ").append(plainText(text)).append("\n");
}
}
