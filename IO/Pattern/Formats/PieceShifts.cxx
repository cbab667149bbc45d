// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PieceShifts.h"

#include "Formats/PageMarks.h"

#include <algorithm>
#include <numeric>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr int placesOfSide = 9; ///< that are tried along each side of a page
constexpr int sweeps = 2;

class Shifts
{
public:
  Shifts(const Pattern& pattern, PagePlan& plan)
    : Source(pattern)
    , Plan(plan)
    , Sheet(Eigen::Vector2d::Zero(),
        Point2(plan.columns * plan.step.x(), plan.rows * plan.step.y()) +
          Point2::Constant(plan.overlap))
    , Marks(pattern.pieces.size())
  {
    const PageMarks legend = pagesOfLegend(plan);
    this->Count.assign(legend.begin(), legend.end());
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    {
      this->Marks[p] = pagesOf(pattern, plan, p);
      this->count(p, 1);
    }
  }

  void run()
  {
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      for (std::size_t p = 0; p < this->Source.pieces.size(); ++p)
      {
        this->shift(p);
      }
    }
  }

private:
  using Box = Eigen::AlignedBox2d;

  void count(std::size_t piece, int by)
  {
    for (std::size_t k = 0; k < this->Count.size(); ++k)
    {
      this->Count[k] += by * this->Marks[piece][k];
    }
  }

  /// Pages that this piece alone needs, and all that it is on, which counts where those are equal.
  std::pair<int, int> cost(const PageMarks& marks) const
  {
    std::pair<int, int> result{ 0, 0 };
    for (std::size_t k = 0; k < marks.size(); ++k)
    {
      result.first += marks[k] != 0 && this->Count[k] == 0 ? 1 : 0;
      result.second += marks[k];
    }
    return result;
  }

  Box boxOf(std::size_t piece) const
  {
    const Point2& corner = this->Plan.layout.corners[piece];
    return { corner, corner + this->Source.pieces[piece].extent };
  }

  bool isFree(std::size_t piece) const
  {
    const Box box = this->boxOf(piece);
    const Box around(
      box.min() - Point2::Constant(pieceGap - 1e-9), box.max() + Point2::Constant(pieceGap - 1e-9));
    if (!this->Sheet.contains(box) ||
      around.intersects(
        Box(this->Plan.origin, this->Plan.origin + legendExtent(this->Plan.hasMap))))
    {
      return false;
    }
    for (std::size_t q = 0; q < this->Source.pieces.size(); ++q)
    {
      if (q != piece && around.intersects(this->boxOf(q)))
      {
        return false;
      }
    }
    return true;
  }

  /// Tries places all over the sheet.
  void shift(std::size_t piece)
  {
    Point2& corner = this->Plan.layout.corners[piece];
    Point2 best = corner;
    this->count(piece, -1);
    std::pair<int, int> least = this->cost(this->Marks[piece]);
    const Point2 by = this->Plan.step / (placesOfSide - 1);
    for (int y = 0; y < (placesOfSide - 1) * this->Plan.rows; ++y)
    {
      for (int x = 0; x < (placesOfSide - 1) * this->Plan.columns; ++x)
      {
        // From where the first page's outer band ends.
        corner = this->Plan.origin + Point2(x * by.x(), y * by.y());
        if (!this->isFree(piece))
        {
          continue;
        }
        PageMarks marks = pagesOf(this->Source, this->Plan, piece);
        const std::pair<int, int> now = this->cost(marks);
        if (now < least)
        {
          least = now;
          best = corner;
          this->Marks[piece] = std::move(marks);
        }
      }
    }
    corner = best;
    this->count(piece, 1);
  }

  const Pattern& Source;
  PagePlan& Plan;
  Box Sheet;
  std::vector<PageMarks> Marks;
  std::vector<int> Count; ///< by page, of pieces and the legend
};
}

void saveByShifts(const Pattern& pattern, PagePlan& plan)
{
  if (!pattern.fabric)
  {
    Shifts(pattern, plan).run();
  }
}
}
}
