// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/PatternStrokes.h"
#include "Formats/PdfPages.h"

#include <array>
#include <set>
#include <string>

namespace flattening::pattern
{
enum class Anchor
{
  Start,
  Middle,
  End,
};

/// What pages are drawn on, in millimetres, y down from the upper left corner of the paper. A path
/// is stroked with the pen, which it keeps until another one is taken.
class PageCanvas
{
public:
  PageCanvas() = default;
  virtual ~PageCanvas() = default;
  PageCanvas(const PageCanvas&) = delete;
  PageCanvas& operator=(const PageCanvas&) = delete;

  virtual void beginPage(const Point2& paper) = 0;
  virtual void endPage() = 0;
  /// Between save() and restore() transformations and clips are local.
  virtual void save() = 0;
  virtual void restore() = 0;
  virtual void translate(const Point2& by) = 0;
  virtual void scale(double factor) = 0;
  virtual void clip(const Point2& corner, const Point2& extent) = 0;
  /// \param dashes lengths on, off, on, off; 0 ends them
  virtual void pen(const Color& color, double width, const std::array<double, 4>& dashes) = 0;
  virtual void moveTo(const Point2& to) = 0;
  virtual void lineTo(const Point2& to) = 0;
  virtual void curveTo(const Point2& one, const Point2& two, const Point2& to) = 0;
  virtual void rectangle(const Point2& corner, const Point2& extent) = 0;
  virtual void closePath() = 0;
  virtual void stroke(bool filled) = 0;
  /// \param words valid UTF-8 on one line \param at middle of the text's height
  /// \param angle anti-clockwise
  virtual void text(
    const std::string& words, const Point2& at, double height, Anchor anchor, double angle) = 0;
};

/// What of a pattern is drawn on its pages.
struct PageSelection
{
  bool pages = false; ///< frames, crosses and legend, and the pages of tables
  bool texts = false; ///< of the pieces
  std::set<LineKind> roles;
};

/// The roles of all strokes of a pattern.
std::set<LineKind> rolesOf(const Pattern& pattern);

/// Draws a pattern at 1:1 on the pages of a plan. Each page bears its row and column and, at the
/// corners of the band that it shares with its neighbours, the crosses at which they are joined;
/// the first one a test rectangle of 100 mm x 50 mm.
void drawPages(const Pattern& pattern, PaperSize paper, const PagePlan& plan,
  const PageSelection& selection, PageCanvas& canvas);

/// Plans the pages and draws all of a pattern on them. \return that of planPages()
Status drawPages(const Pattern& drawing, const PageOptions& options, PageCanvas& canvas);

/// Moves each text that lies on the border of a page, or on a page that is left out, onto a page
/// nearby, within its piece and as far from its lines and other texts as that allows. Title and
/// labels of a piece move together.
void keepTextsOnPages(const PagePlan& plan, Pattern& pattern);
}
