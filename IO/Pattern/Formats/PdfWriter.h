// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"

namespace flattening::pattern
{
/// A pattern as PDF at 1:1, on the pages that drawPages() draws, by cairo.
Status makePdf(const Pattern& drawing, const PageOptions& options, std::string& pdf);
}
