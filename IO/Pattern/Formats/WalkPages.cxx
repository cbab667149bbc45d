// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/WalkPages.h"

#include "Drawing/PatternStrokes.h"
#include "Formats/PdfPages.h"
#include "Formats/VisualOrder.h"
#include "Outlines/PatternText.h"

#include <cairo-pdf.h>

#include <array>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr std::array<double, 2> paper{ 210.0, 297.0 };
constexpr double walkMargin = 15.0;
constexpr double letters = 3.0;
constexpr double lineFeed = 5.0;
/// Where columns start; texts to the left of the fourth are cut to fit.
constexpr std::array<double, 10> columns{ 15.0, 48.0, 74.0, 100.0, 108.0, 126.0, 144.0, 162.0,
  178.0, 197.0 };

void write(cairo_t* context, const std::string& text, double x, double y, double height)
{
  cairo_set_font_size(context, height);
  cairo_move_to(context, x, y);
  cairo_show_text(context, visualOrder(cleanText(text)).c_str());
}

void writeRow(cairo_t* context, const std::vector<std::string>& row, double y)
{
  for (std::size_t k = 0; k < row.size() && k + 1 < columns.size(); ++k)
  {
    write(
      context, fitText(row[k], letters, columns[k + 1] - columns[k] - 1.0), columns[k], y, letters);
  }
}
}

void drawWalkPages(const Pattern& pattern, cairo_surface_t* surface, cairo_t* context)
{
  cairo_pdf_surface_set_size(
    surface, pointsPerMillimetre * paper[0], pointsPerMillimetre * paper[1]);
  const double top = walkMargin + 14.0;
  for (std::size_t next = 1; next < pattern.walk.size();)
  {
    cairo_identity_matrix(context);
    cairo_scale(context, pointsPerMillimetre, pointsPerMillimetre);
    cairo_set_source_rgb(context, 0.0, 0.0, 0.0);
    write(context, fitText("Walk of the seams: " + pattern.name, 5.0, paper[0] - 2.0 * walkMargin),
      walkMargin, walkMargin + 5.0, 5.0);
    writeRow(context, pattern.walk.front(), top);
    cairo_set_line_width(context, 0.2);
    cairo_move_to(context, walkMargin, top + 1.5);
    cairo_line_to(context, paper[0] - walkMargin, top + 1.5);
    cairo_stroke(context);
    for (double y = top + 1.5 * lineFeed; y < paper[1] - walkMargin && next < pattern.walk.size();
         y += lineFeed)
    {
      writeRow(context, pattern.walk[next++], y);
    }
    cairo_show_page(context);
  }
}
}
}
