// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"

struct _cairo;
struct _cairo_surface;

namespace flattening
{
namespace pattern
{
/// Draws the table of Pattern::walk on as many A4 pages as it takes.
void drawWalkPages(const Pattern& pattern, _cairo_surface* surface, _cairo* context);
}
}
