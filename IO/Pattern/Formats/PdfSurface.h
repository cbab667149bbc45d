// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"

struct _cairo;
struct _cairo_surface;

namespace flattening
{
namespace pattern
{
/// A surface of cairo that writes a PDF, and says what it is of.
/// \param pdf gets the file's bytes until it is closed
_cairo_surface* openPdf(const Pattern& pattern, const PagePlan& plan, std::string& pdf);

/// Writes what is left, which destroys nothing. \return InvalidPattern where something went wrong
Status closePdf(_cairo_surface* surface, _cairo* context);
}
}
