// SPDX-License-Identifier: BSD-3-Clause
#include "Outlines/PatternText.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
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
constexpr std::uint32_t replacement = 0xFFFD;

/// Reads one code point at `at` and moves on; bytes that are no UTF-8 give `replacement`, each.
std::uint32_t nextCodePoint(std::string_view text, std::size_t& at)
{
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byte(at);
  const std::size_t length = first < 0x80 ? 1
    : first < 0xC2                        ? 0
    : first < 0xE0                        ? 2
    : first < 0xF0                        ? 3
    : first < 0xF5                        ? 4
                                          : 0;
  if (length == 0 || at + length > text.size())
  {
    ++at;
    return replacement;
  }
  if (length == 1)
  {
    ++at;
    return first;
  }
  std::uint32_t code = first & (0xFFu >> (length + 1));
  for (std::size_t k = 1; k < length; ++k)
  {
    if ((byte(at + k) & 0xC0u) != 0x80u)
    {
      ++at;
      return replacement;
    }
    code = (code << 6) | (byte(at + k) & 0x3Fu);
  }
  static constexpr std::array<std::uint32_t, 5> least{ 0, 0, 0x80, 0x800, 0x10000 };
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < least[length] || code > 0x10FFFF || surrogate)
  {
    ++at;
    return replacement;
  }
  at += length;
  return code;
}

void append(std::string& text, std::uint32_t code)
{
  const auto push = [&text](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
  if (code < 0x80)
  {
    push(code);
  }
  else if (code < 0x800)
  {
    push(0xC0 | (code >> 6));
    push(0x80 | (code & 0x3F));
  }
  else if (code < 0x10000)
  {
    push(0xE0 | (code >> 12));
    push(0x80 | ((code >> 6) & 0x3F));
    push(0x80 | (code & 0x3F));
  }
  else
  {
    push(0xF0 | (code >> 18));
    push(0x80 | ((code >> 12) & 0x3F));
    push(0x80 | ((code >> 6) & 0x3F));
    push(0x80 | (code & 0x3F));
  }
}

bool isControl(std::uint32_t code)
{
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029;
}
}

std::string cleanText(const std::string& text)
{
  std::string clean;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::uint32_t code = nextCodePoint(text, at);
    append(clean, isControl(code) ? ' ' : code == 0xFFFE || code == 0xFFFF ? replacement : code);
  }
  return clean;
}

std::string escapeXml(const std::string& text)
{
  std::string escaped;
  for (const char c : cleanText(text))
  {
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string escapeDxf(const std::string& text)
{
  const std::string clean = cleanText(text);
  std::string escaped;
  for (std::size_t at = 0; at < clean.size();)
  {
    const std::uint32_t code = nextCodePoint(clean, at);
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
  for (std::size_t at = 0; at < text.size(); ++characters)
  {
    nextCodePoint(text, at);
  }
  return 0.62 * height * static_cast<double>(characters);
}
}
