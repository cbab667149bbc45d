// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"

#include <vector>

namespace flattening
{
namespace pattern
{
/// By page of a plan, row by row: whether something is on it.
using PageMarks = std::vector<unsigned char>;

/// Marks the pages of a plan that show a part of a segment of the sheet.
void markSegment(const PagePlan& plan, const Point2& from, const Point2& to, PageMarks& marks);

/// The pages that show a part of a piece, where the plan has laid it.
PageMarks pagesOf(const Pattern& pattern, const PagePlan& plan, std::size_t piece);

/// Those that show the legend.
PageMarks pagesOfLegend(const PagePlan& plan);
}
}
