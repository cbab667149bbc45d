// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Formats/SheetLayout.h"

#include <vector>

namespace flattening::pattern
{
enum class PaperSize
{
  A4,
  Letter,
  A3,
  A0,
  Sheet, ///< one page as large as the pattern
};

struct PageOptions
{
  PaperSize paper = PaperSize::A4;
  double overlap = 10.0; ///< of neighbouring pages, millimetres
  int maximumPages = 200;
};

const char* paperName(PaperSize paper);

/// The unit of PDF, of which cairo's surfaces are made.
constexpr double pointsPerMillimetre = 72.0 / 25.4;
/// Left free on every side of a page, because printers cannot print there; millimetres.
constexpr double pageMargin = 10.0;

/// One page; rows and columns from 0 at the upper left.
struct Tile
{
  int row = 0;
  int column = 0;
};

/// How a pattern falls on pages.
struct PagePlan
{
  SheetLayout layout;
  bool tiled = true;
  bool hasMap = false;               ///< the legend shows the pages
  Point2 paper = Point2::Zero();     ///< of one page
  Point2 printable = Point2::Zero(); ///< paper without margins: what a page shows of the sheet
  Point2 step = Point2::Zero();      ///< from page to page
  double overlap = 0.0;
  Point2 origin = Point2::Zero(); ///< of the legend on the sheet
  int columns = 1;
  int rows = 1;
  std::vector<Tile> pages; ///< those on which there is something, row by row
};

/// Size of the legend at the sheet's upper left: test rectangle, title, map.
Point2 legendExtent(bool withMap);

/// Chooses the layout and the way to hold the paper that need the fewest pages.
/// A Sheet that is larger than PDF allows (5080 mm) is divided into pages of that size.
/// \return TooLarge where more than maximumPages are needed
Status planPages(const Pattern& pattern, const PageOptions& options, PagePlan& plan);

/// Before a pattern is there: whether pieces of this area, in mm2, may fit on the pages.
/// \return PatternTooLarge where they do not
Status checkPages(double area, const PageOptions& options);

/// "A1": row A, column 1.
std::string tileName(const Tile& tile);

/// Whether the plan has this page.
bool hasPage(const PagePlan& plan, const Tile& tile);

/// By page of a plan, row by row: whether something is on it.
using PageMarks = std::vector<unsigned char>;

/// The pages that show a part of a piece, where the plan has laid it.
PageMarks pagesOf(const Pattern& pattern, const PagePlan& plan, std::size_t piece);
}
