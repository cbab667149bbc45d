// SPDX-License-Identifier: BSD-3-Clause
#include "CurveFractions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace flattening
{
namespace bridge
{
namespace
{
std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  const std::size_t last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

/// Whether the whole text is a number, whatever the language of the program.
template <typename Number>
bool parseWhole(const std::string& text, Number& value)
{
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

bool readOne(const std::string& entry, bool ease, CurveFraction& fraction)
{
  const std::size_t sign = entry.rfind('=');
  if (sign == std::string::npos || entry.back() != '%')
  {
    return false;
  }
  std::string value = trimmed(entry.substr(sign + 1, entry.size() - sign - 2));
  value.erase(0, value.size() > 1 && value[0] == '+' && value[1] != '-' ? 1 : 0);
  const bool fits = parseWhole(value, fraction.fraction) && std::abs(fraction.fraction) < 100.0 &&
    (ease || fraction.fraction >= 0.0);
  fraction.fraction /= 100.0;
  fraction.curve = trimmed(entry.substr(0, sign));
  const std::size_t colon = fraction.curve.rfind(':');
  int piece = 0;
  if (ease && colon != std::string::npos &&
    parseWhole(trimmed(fraction.curve.substr(colon + 1)), piece))
  {
    fraction.piece = piece - 1;
    fraction.curve = trimmed(fraction.curve.substr(0, colon));
    return fits && piece >= 1 && !fraction.curve.empty();
  }
  return fits && !fraction.curve.empty();
}
}

bool readFractions(const std::string& text, bool ease, std::vector<CurveFraction>& fractions)
{
  fractions.clear();
  for (std::size_t at = 0; at <= text.size();)
  {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const std::string entry = trimmed(text.substr(at, end - at));
    at = end + 1;
    if (!entry.empty() && !readOne(entry, ease, fractions.emplace_back()))
    {
      return false;
    }
  }
  return true;
}

std::string fractionsText(const std::vector<CurveFraction>& fractions, bool ease)
{
  std::string text;
  for (const CurveFraction& fraction : fractions)
  {
    std::array<char, 32> digits{};
    constexpr int precision = 15;
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(),
      100.0 * fraction.fraction, std::chars_format::general, precision);
    text += (text.empty() ? "" : "; ") + fraction.curve +
      (fraction.piece < 0 ? "" : ":" + std::to_string(fraction.piece + 1)) +
      (ease && fraction.fraction > 0.0 ? "=+" : "=") + std::string(digits.data(), end.ptr) + "%";
  }
  return text;
}
}
}
