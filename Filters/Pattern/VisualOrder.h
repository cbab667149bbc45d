// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace flattening
{
namespace pattern
{
/// The characters of a line in the order in which they stand on paper from the left, for libraries
/// that draw one after the other: words of Hebrew and other letters that are written from the right
/// are turned round, numbers among them are not, and brackets are mirrored. This is the Unicode
/// bidirectional algorithm (Unicode Standard Annex 9) without its marks of embedding, for lines
/// that run from the left as soon as they have a letter that does, as the patterns' own words.
/// Letters of Arabic are not joined.
/// \param text valid UTF-8
std::string visualOrder(const std::string& text);
}
}
