// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PdfPages.h"

#include "DrawnPieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace
{
using namespace drawnpieces;

/// A sheet of upright A4 pages.
PagePlan sheetOf(int rows, int columns)
{
  PagePlan plan;
  plan.paper = { 210.0, 297.0 };
  plan.overlap = 10.0;
  plan.printable = { 190.0, 277.0 };
  plan.step = { 180.0, 267.0 };
  plan.origin = { 10.0, 10.0 };
  plan.hasMap = true;
  plan.rows = rows;
  plan.columns = columns;
  return plan;
}

/// By page how many pieces are on it, and the legend.
std::vector<int> useOf(const Pattern& pattern, const PagePlan& plan)
{
  const PageMarks legend = pagesOfLegend(plan);
  std::vector<int> use(legend.begin(), legend.end());
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
  {
    const PageMarks marks = pagesOf(pattern, plan, p);
    std::transform(use.begin(), use.end(), marks.begin(), use.begin(), std::plus<>());
  }
  return use;
}

int pagesIn(const std::vector<int>& use)
{
  return static_cast<int>(
    use.size() - static_cast<std::size_t>(std::count(use.begin(), use.end(), 0)));
}
}

TEST(PieceShifts, APieceAcrossFourPagesComesToLieOnOne)
{
  Pattern pattern;
  pattern.pieces = { rectangle({ 150.0, 200.0 }) };
  PagePlan plan = sheetOf(2, 2);
  plan.layout.corners = { { 110.0, 150.0 } };
  EXPECT_EQ(pagesIn(useOf(pattern, plan)), 4);
  saveByShifts(pattern, plan);
  EXPECT_EQ(pagesIn(useOf(pattern, plan)), 2); // the legend on its own, the piece on another
}

TEST(PieceShifts, NeedNoMorePagesAndLeavePiecesApartOnTheSheet)
{
  std::mt19937 random(5);
  int saved = 0;
  for (int k = 0; k < 40; ++k)
  {
    const auto number = [&random](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    Pattern pattern;
    for (int p = 0; p < 1 + k % 7; ++p)
    {
      pattern.pieces.push_back(rectangle({ number(20.0, 300.0), number(20.0, 400.0) }));
    }
    PagePlan plan = sheetOf(8, 3);
    plan.layout = layOut(pattern, 3 * plan.step.x() - plan.overlap, 115.0);
    for (Point2& corner : plan.layout.corners)
    {
      corner += plan.origin;
    }
    const int before = pagesIn(useOf(pattern, plan));
    saveByShifts(pattern, plan);
    const int after = pagesIn(useOf(pattern, plan));
    EXPECT_LE(after, before) << k;
    saved += before - after;
    Eigen::AlignedBox2d taken(plan.origin, plan.origin + legendExtent(true));
    std::vector<Eigen::AlignedBox2d> boxes{ taken };
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    {
      const Point2 low = plan.layout.corners[p];
      const Point2 high = low + pattern.pieces[p].extent;
      for (std::size_t q = 0; q < boxes.size(); ++q)
      {
        const double least = q == 0 ? 10.0 : 15.0; // as layOut() is asked for
        EXPECT_GE(
          std::sqrt(boxes[q].squaredExteriorDistance(Eigen::AlignedBox2d(low, high))), least - 1e-6)
          << k;
      }
      EXPECT_TRUE((low.array() >= plan.origin.array() - 1e-9).all()) << k;
      EXPECT_LE(high.x(), 3 * 180.0 + 10.0 + 1e-6) << k;
      EXPECT_LE(high.y(), 8 * 267.0 + 10.0 + 1e-6) << k;
      boxes.emplace_back(low, high);
    }
  }
  EXPECT_GT(saved, 20);
}
