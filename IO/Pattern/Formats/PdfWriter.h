// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"

namespace flattening::pattern
{
/// A pattern as PDF at 1:1, on the pages that drawPages() draws, by cairo.
Status makePdf(const Pattern& drawing, const PageOptions& options, std::string& pdf);

/// The characters of a line in the order in which they stand on paper from the left, for libraries
/// that draw one after the other, by the Unicode bidirectional algorithm (Unicode Standard Annex
/// 9): words of letters that are written from the right are turned round, numbers among them are
/// not, brackets are mirrored, and letters of Arabic take the forms in which they join. A line runs
/// from the left as soon as it has a letter that does, as the patterns' own words; its marks of
/// direction and embedding are taken out. A line without letters from the right is returned as it
/// is.
/// \param text valid UTF-8
/// \throws std::bad_alloc
std::string visualOrder(const std::string& text);
}
