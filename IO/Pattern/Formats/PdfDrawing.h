// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/PatternStrokes.h"
#include "Formats/PdfPages.h"

#include <set>

namespace flattening
{
namespace pattern
{
/// What of a pattern is drawn on its pages.
struct PdfSelection
{
  bool pages = false; ///< frames, crosses and legend, and the pages of the walk
  bool texts = false; ///< of the pieces
  std::set<StrokeRole> roles;
};

/// Draws pages by cairo. \param pdf the file's bytes
Status drawPdf(const Pattern& pattern, PaperSize paper, const PagePlan& plan,
  const PdfSelection& selection, std::string& pdf);
}
}
