// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"

namespace flattening::pattern
{
/// A pattern as PDF at 1:1, on as many pages as it needs. Each page bears its row and column and,
/// at the corners of the band that it shares with its neighbours, the crosses at which they are
/// joined; the first one a test rectangle of 100 mm x 50 mm.
Status makePdf(const Pattern& drawing, const PageOptions& options, std::string& pdf);
}
