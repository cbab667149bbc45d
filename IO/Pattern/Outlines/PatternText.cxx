// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/PatternText.h"

#include "Base/Utf8.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#ifndef __cpp_lib_to_chars
#include <iomanip>
#include <locale>
#include <sstream>
#endif
#include <string_view>

namespace flattening::pattern
{
namespace
{
bool isControl(std::uint32_t code)
{
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029;
}
}

std::string cleanText(const std::string& text)
{
  std::string clean;
  for (std::string_view rest(text); !rest.empty();)
  {
    const std::string_view before = rest;
    const std::optional<std::uint32_t> code = takeCharacter(rest);
    clean += !code || *code == 0xFFFE || *code == 0xFFFF ? "\uFFFD"
      : isControl(*code)                                 ? " "
                         : before.substr(0, before.size() - rest.size());
  }
  return clean;
}

std::string escapeXml(const std::string& text)
{
  std::string escaped;
  for (const char c : cleanText(text))
  {
    escaped += c == '&' ? "&amp;"
      : c == '<'        ? "&lt;"
      : c == '>'        ? "&gt;"
      : c == '"'        ? "&quot;"
      : c == '\''       ? "&#39;"
                        : std::string(1, c);
  }
  return escaped;
}

std::string escapeDxf(const std::string& text)
{
  const std::string clean = cleanText(text);
  std::string escaped;
  for (std::string_view rest(clean); !rest.empty();)
  {
    const std::uint32_t code = takeCharacter(rest).value_or(0xFFFD);
    if (code < 0x80)
    {
      escaped += static_cast<char>(code);
    }
    else if (code > 0xFFFF)
    {
      escaped += '?';
    }
    else
    {
      std::array<char, 16> buffer{};
      std::snprintf(buffer.data(), buffer.size(), "\\U+%04X", static_cast<unsigned>(code));
      escaped += buffer.data();
    }
  }
  return escaped;
}

std::string dxfSymbol(const std::string& text, std::size_t most)
{
  std::string symbol;
  for (const char c : text)
  {
    const bool lower = c >= 'a' && c <= 'z';
    const bool plain = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    symbol += lower ? static_cast<char>(c - 'a' + 'A') : plain ? c : '_';
  }
  return symbol.substr(0, most);
}

std::string formatNumber(double value, int digits)
{
#ifdef __cpp_lib_to_chars
  std::array<char, 400> buffer{};
  const auto result = std::to_chars(
    buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  std::string text(buffer.data(), result.ptr);
#else // older libraries of clang have to_chars() of whole numbers alone
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(digits) << value;
  std::string text = out.str();
#endif
  if (text.find('.') != std::string::npos)
  {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
    {
      text.pop_back();
    }
  }
  return text == "-0" ? "0" : text;
}

std::string exactNumber(double value)
{
#ifdef __cpp_lib_to_chars
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return std::string(buffer.data(), end);
#else
  std::string text;
  for (int digits = 15; digits <= 17; ++digits)
  {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(digits) << value;
    text = out.str();
    double read = 0.0;
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    if (in >> read && read == value)
    {
      break;
    }
  }
  return text;
#endif
}

std::string csvField(const std::string& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text)
  {
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return quoted + "\"";
}

double textWidth(const std::string& text, double height)
{
  std::size_t characters = 0;
  for (std::string_view rest(text); !rest.empty(); ++characters)
  {
    takeCharacter(rest);
  }
  return 0.62 * height * static_cast<double>(characters);
}
}
