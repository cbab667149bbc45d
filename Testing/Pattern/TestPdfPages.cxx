// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PageDrawing.h"
#include "Formats/PatternFile.h"
#include "Formats/PatternOptionTable.h"
#include "Outlines/PatternText.h"

#include "DrawnPieces.h"

#include <cstdio>
#include <random>

namespace
{
using namespace drawnpieces;

/// Rectangles of the given extents.
Pattern patternOf(const Points2& extents)
{
  Pattern pattern;
  for (const Point2& extent : extents)
  {
    pattern.pieces.push_back(rectangle(extent));
  }
  return pattern;
}

PagePlan planOf(const Pattern& pattern, PaperSize paper)
{
  PageOptions options;
  options.paper = paper;
  PagePlan plan;
  const Status status = planPages(pattern, options, plan);
  EXPECT_TRUE(status.ok()) << status.message;
  return plan;
}

/// Of a piece on the sheet.
Box boxOf(const Pattern& pattern, const SheetLayout& layout, std::size_t piece)
{
  return { layout.corners[piece], layout.corners[piece] + pattern.pieces[piece].extent };
}

/// Of a place on the sheet.
bool isOnAPage(const PagePlan& plan, const Point2& at)
{
  return std::any_of(plan.pages.begin(), plan.pages.end(), [&](const Tile& tile) {
    const Point2 low(tile.column * plan.step.x(), tile.row * plan.step.y());
    return (at - low).minCoeff() >= -1e-9 && (low + plan.printable - at).minCoeff() >= -1e-9;
  });
}
}

TEST(PdfPages, TilesAreNamedLikeCellsOfATable)
{
  EXPECT_EQ(tileName({ 0, 0 }), "A1");
  EXPECT_EQ(tileName({ 25, 9 }), "Z10");
  EXPECT_EQ(tileName({ 26, 0 }), "AA1");
  EXPECT_EQ(tileName({ 26 * 27, 0 }), "AAA1");
}

TEST(PdfPages, EveryPointOfEveryLineIsOnAPage)
{
  const Pattern pattern = patternOf({ { 700.0, 500.0 }, { 250.0, 800.0 }, { 30.0, 40.0 } });
  for (const PaperSize paper : { PaperSize::A4, PaperSize::Letter, PaperSize::A3, PaperSize::A0 })
  {
    const PagePlan plan = planOf(pattern, paper);
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    {
      const Points2& corners = pattern.pieces[p].lines.front().points;
      for (int step = 0; step < 4000; ++step)
      {
        const std::size_t k = static_cast<std::size_t>(step / 1000);
        const Point2 q = corners[k] + (step % 1000) / 1000.0 * (corners[(k + 1) % 4] - corners[k]);
        EXPECT_TRUE(isOnAPage(plan, plan.layout.place(pattern, p, q)));
      }
    }
  }
}

TEST(PdfPages, AFrameLeavesItsMiddlePagesOut)
{
  const PagePlan plan = planOf(patternOf({ { 1500.0, 1500.0 } }), PaperSize::A4);
  EXPECT_LT(plan.pages.size(), static_cast<std::size_t>(plan.rows * plan.columns));
  EXPECT_GT(plan.pages.size(), 10U);
}

TEST(PdfPages, PiecesDoNotOverlapOnTheSheet)
{
  const Pattern pattern =
    patternOf({ { 300.0, 200.0 }, { 200.0, 300.0 }, { 250.0, 100.0 }, { 500.0, 20.0 } });
  const SheetLayout layout = layOut(pattern, 520.0, 50.0);
  const Point2 gap = Point2::Constant(15.0);
  for (std::size_t a = 0; a < pattern.pieces.size(); ++a)
  {
    const Box one = boxOf(pattern, layout, a);
    for (std::size_t b = a + 1; b < pattern.pieces.size(); ++b)
    {
      const Box common =
        Box(one.min() - gap, one.max() + gap).intersection(boxOf(pattern, layout, b));
      EXPECT_LE(common.sizes().minCoeff(), 1e-9) << a << ", " << b;
    }
  }
}

TEST(PdfPages, TooLargeIsRefusedWithTheSizeOfThePiece)
{
  PagePlan plan;
  PageOptions options;
  const auto refuse = [&](double size, PaperSize paper) {
    options.paper = paper;
    const Status status = planPages(patternOf({ { size, 0.5 * size } }), options, plan);
    EXPECT_EQ(status.code, StatusCode::PatternTooLarge) << size;
    double width = 0.0;
    double height = 0.0;
    const std::size_t at = status.message.find("rectangle, measures ");
    ASSERT_NE(at, std::string::npos) << status.message;
    ASSERT_EQ(std::sscanf(
                status.message.c_str() + at, "rectangle, measures %lf m x %lf m", &width, &height),
      2)
      << status.message;
    EXPECT_NEAR(width, 1e-3 * size, 1e-3 + 1e-9 * size);
    EXPECT_NEAR(height, 0.5e-3 * size, 1e-3 + 1e-9 * size);
  };
  for (const double size : { 1e6, 1e9, 1e14, 1e62 })
  {
    refuse(size, PaperSize::Sheet);
    refuse(size, PaperSize::A4);
  }
}

TEST(PdfPages, ASheetBeyondTheLimitOfPdfIsDivided)
{
  const Pattern pattern = patternOf({ { 29e3, 1400.0 }, { 900.0, 700.0 } });
  const PagePlan plan = planOf(pattern, PaperSize::Sheet);
  EXPECT_TRUE(plan.tiled);
  EXPECT_LE(plan.paper.maxCoeff(), 5080.0);
  EXPECT_EQ(plan.pages.size(), 6U); // of 5.05 m each
  for (const double at : { 0.0, 14e3, 29e3 })
  {
    EXPECT_TRUE(isOnAPage(plan, plan.layout.place(pattern, 0, { at, 700.0 })));
  }
}

TEST(PatternFile, AnOptionOutOfItsRangeIsRefusedByNameAndRange)
{
  const auto expectRefusal = [](const FileOptions& options, const std::vector<std::string>& words) {
    Pattern drawing;
    std::string content;
    const Status status = makePatternFile({}, options, drawing, content);
    EXPECT_EQ(status.code, StatusCode::InvalidOption);
    for (const std::string& word : words)
    {
      EXPECT_NE(status.message.find(word), std::string::npos) << word << ": " << status.message;
    }
  };
  for (const PatternOption& option : patternOptionTable())
  {
    for (const double value : { std::nan(""), option.minimum - 2.0, option.maximum + 1.0 })
    {
      if (option.setIn && option.minimum < option.maximum &&
        (option.type == OptionType::Number || std::isfinite(value)))
      {
        FileOptions options;
        option.setIn(options, value);
        expectRefusal(options, { option.property + " = ", rangeOf(option) });
      }
    }
  }
  FileOptions options;
  options.pattern.pieceQuantities = { 0, -1 };
  expectRefusal(options, { "PieceQuantities of piece 2 = -1", "[1, 1000000]" });
  options.pattern.notchesOfCurve["hem"] = { 1.0, -3.0 };
  expectRefusal(options, { "CurveNotches of hem = 1 -3" });
  options.pattern.allowanceOfCurve["hem"] = std::nan("");
  expectRefusal(options, { "CurveAllowances of hem = nan", "[0, 1000000]" });
}

TEST(PdfPages, APieceThatFitsAPageIsNotSplit)
{
  std::mt19937 random(7);
  for (int k = 0; k < 30; ++k)
  {
    const auto number = [&random](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    Points2 extents;
    for (int p = 0; p < 2 + k % 9; ++p)
    {
      const double most = p % 4 == 3 ? 600.0 : 160.0;
      extents.emplace_back(number(20.0, most), number(20.0, 1.4 * most));
    }
    const Pattern pattern = patternOf(extents);
    const PagePlan plan = planOf(pattern, PaperSize::A4);
    const Point2 room = plan.step - Point2::Constant(plan.overlap);
    for (std::size_t p = 0; p < extents.size(); ++p)
    {
      const PageMarks marks = pagesOf(pattern, plan, p);
      if ((room - extents[p]).minCoeff() >= 0.0)
      {
        EXPECT_EQ(std::count(marks.begin(), marks.end(), 1), 1) << k << ": " << extents[p];
      }
      for (std::size_t q = 0; q < p; ++q)
      {
        const Box one = boxOf(pattern, plan.layout, p);
        const Box other = boxOf(pattern, plan.layout, q);
        // On pages beside each other they are as far apart as these overlap.
        EXPECT_GE(std::sqrt(one.squaredExteriorDistance(other)), plan.overlap - 1e-6) << k;
      }
    }
  }
}

TEST(PdfPages, TextsAreWholeOnAPageAndStayInTheirPiece)
{
  // Larger than any page, with pages left out in its middle.
  Pattern pattern = patternOf({ { 1500.0, 1500.0 }, { 500.0, 300.0 } });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.02, 0.98);
  for (PatternPiece& piece : pattern.pieces)
  {
    for (int k = 0; k < 60; ++k)
    {
      PatternText& text = piece.texts.emplace_back();
      text.role = k < 3 ? (k == 0 ? TextRole::Title : TextRole::Label) : TextRole::Join;
      text.text = k < 3 ? "a title of some length" : "AB";
      text.position = k < 3
        ? Point2(piece.extent / 2.0 - Point2(0.0, 10.0 * k))
        : Point2(share(random) * piece.extent.x(), share(random) * piece.extent.y());
      text.angle = k < 3 ? 0.0 : share(random) * 3.0 - 1.5;
    }
  }
  const PagePlan plan = planOf(pattern, PaperSize::A4);
  const Pattern before = pattern;
  keepTextsOnPages(plan, pattern);
  int moved = 0;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
  {
    const std::vector<PatternText>& texts = pattern.pieces[p].texts;
    for (std::size_t k = 0; k < texts.size(); ++k)
    {
      moved += texts[k].position == before.pieces[p].texts[k].position ? 0 : 1;
      EXPECT_GT(texts[k].position.minCoeff(), 0.0);
      EXPECT_GT((pattern.pieces[p].extent - texts[k].position).minCoeff(), 0.0);
      const double half = textWidth(texts[k].text, texts[k].height) / 2.0;
      const Point2 along = half * Point2(std::cos(texts[k].angle), std::sin(texts[k].angle));
      const Point2 from = plan.layout.place(pattern, p, texts[k].position - along);
      const Point2 to = plan.layout.place(pattern, p, texts[k].position + along);
      int whole = 0;
      int shown = 0; // a text in the strip that pages share is on both
      for (const Tile& tile : plan.pages)
      {
        const Point2 low(tile.column * plan.step.x(), tile.row * plan.step.y());
        const Point2 high = low + plan.printable;
        const auto isOn = [&](const Point2& end) {
          return (end - low).minCoeff() > 0.0 && (high - end).minCoeff() > 0.0;
        };
        whole += isOn(from) && isOn(to) ? 1 : 0;
        shown += isOn(from) || isOn(to) ? 1 : 0;
      }
      EXPECT_EQ(whole, 1) << texts[k].text << k;
      EXPECT_EQ(shown, 1) << texts[k].text << k;
    }
    // The block of the title stays one.
    const std::vector<PatternText>& old = before.pieces[p].texts;
    const Point2 turned = texts[0].position - texts[2].position;
    EXPECT_NEAR((turned - (old[0].position - old[2].position)).norm(), 0.0, 1e-9);
  }
  EXPECT_GT(moved, 10);
}
