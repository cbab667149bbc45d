// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace flattening::pattern
{
/// Valid UTF-8 on one line: control characters become spaces, broken bytes U+FFFD, as do the code
/// points that XML forbids.
std::string cleanText(const std::string& text);

/// Clean text for the content and the attributes of XML.
std::string escapeXml(const std::string& text);

/// Clean text in 7 bits, as DXF writes it: \U+00E4 for an a with two dots. What lies beyond 16 bits
/// becomes a question mark.
std::string escapeDxf(const std::string& text);

/// A name that every DXF reader takes: capitals, digits and underscores, at most `most` characters.
std::string dxfSymbol(const std::string& text, std::size_t most);

/// A number with at most `digits` digits after the point, without trailing zeros, never "-0"; the
/// decimal separator is a point in every locale.
std::string formatNumber(double value, int digits);

/// The fewest digits that give the same bits again.
std::string exactNumber(double value);

/// A field of comma-separated values, in quotes where its characters ask for them.
std::string csvField(const std::string& text);

/// Texts with commas between them.
template <typename Texts>
std::string listed(const Texts& texts)
{
  std::string list;
  for (const std::string& text : texts)
  {
    list += (list.empty() ? "" : ", ") + text;
  }
  return list;
}

/// How wide a text is to be taken in a sans-serif face of the given height.
double textWidth(const std::string& text, double height);
}
