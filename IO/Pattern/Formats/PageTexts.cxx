// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PageTexts.h"

#include "Outlines/PatternText.h"
#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace flattening::pattern
{
namespace
{
constexpr double clearance = 1.0; // of texts from the border of a page, mm
constexpr int placesAlong = 12;   // that are tried along each side of a page
constexpr std::size_t mostPages = 6;

/// An upright rectangle around a text.
Box boxOf(const PatternText& text)
{
  const double half = 0.5 * textWidth(text.text, text.height);
  const Point2 along(std::abs(std::cos(text.angle)), std::abs(std::sin(text.angle)));
  const Point2 reach = half * along + 0.5 * text.height * Point2(along.y(), along.x());
  Box box;
  box.extend(text.position - reach);
  box.extend(text.position + reach);
  return box;
}

class PieceTexts
{
public:
  PieceTexts(const PagePlan& plan, const Point2& corner, PatternPiece& piece)
    : Piece(piece)
  {
    const double height = piece.extent.y();
    for (const Tile& tile : plan.pages)
    {
      // Without the strips that it shares with others, on which they are glued to each other.
      const auto strip = [&](int down, int across) {
        bool shared = false;
        for (int k = -1; k <= 1; ++k)
        {
          const Tile other{ tile.row + (down == 0 ? k : down),
            tile.column + (across == 0 ? k : across) };
          shared = shared || hasPage(plan, other);
        }
        return clearance + (shared ? plan.overlap : 0.0);
      };
      const Point2 low = Point2(tile.column * plan.step.x(), tile.row * plan.step.y()) - corner;
      const Point2 high = low + plan.printable - Point2(strip(0, 1), strip(1, 0));
      Box page; // y points up in a piece
      page.extend(Point2(low.x() + strip(0, -1), height - low.y() - strip(-1, 0)));
      page.extend(Point2(high.x(), height - high.y()));
      this->Pages.push_back(page);
    }
    for (const PatternLine& line : piece.lines)
    {
      addSegments(line.points, line.closed, this->Strokes);
      if (isCut(line.kind))
      {
        addSegments(line.points, true, this->Cloth);
      }
    }
    this->Strokes.push_back({ piece.grain.from, piece.grain.to });
  }

  void keep()
  {
    std::vector<std::size_t> title;
    for (std::size_t k = 0; k < this->Piece.texts.size(); ++k)
    {
      const TextRole role = this->Piece.texts[k].role;
      if (role == TextRole::Title || role == TextRole::Label)
      {
        title.push_back(k);
      }
      else
      {
        this->keep({ k });
      }
    }
    this->keep(title);
  }

private:
  void keep(const std::vector<std::size_t>& texts)
  {
    Box box;
    for (const std::size_t k : texts)
    {
      box.extend(boxOf(this->Piece.texts[k]));
    }
    const bool isKept = std::any_of(this->Pages.begin(), this->Pages.end(),
      [&box](const Box& page) { return page.contains(box); });
    if (texts.empty() || isKept)
    {
      return;
    }
    std::pair<int, double> least{ 1 << 30, 0.0 }; // lines and texts that it lies on, and the way
    Point2 best = Point2::Zero();
    for (const Box& page : this->nearestPages(box.center()))
    {
      const Point2 room = page.sizes() - box.sizes();
      const auto tryAt = [&](const Point2& low) {
        const Point2 by = low - box.min();
        const std::pair<int, double> now(this->met(box, by, texts), by.norm());
        if (now < least)
        {
          least = now;
          best = by;
        }
      };
      if (room.minCoeff() < 0.0)
      {
        continue;
      }
      tryAt(box.min().cwiseMax(page.min()).cwiseMin(page.min() + room));
      for (int k = 0; k <= placesAlong * (placesAlong + 2); ++k)
      {
        const Point2 share(k % (placesAlong + 1), std::floor(k / (placesAlong + 1.0)));
        tryAt(page.min() + room.cwiseProduct(share) / placesAlong);
      }
    }
    for (const std::size_t k : texts)
    {
      this->Piece.texts[k].position += best;
    }
  }

  std::vector<Box> nearestPages(const Point2& place) const
  {
    std::vector<Box> pages = this->Pages;
    const auto isNearer = [&place](const Box& a, const Box& b) {
      return (a.center() - place).norm() < (b.center() - place).norm();
    };
    const std::size_t count = std::min(mostPages, pages.size());
    const auto end = pages.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(pages.begin(), end, pages.end(), isNearer);
    pages.resize(count);
    return pages;
  }

  /// How much a box lies on that is moved; beyond the cloth it is worth nothing.
  int met(const Box& box, const Point2& by, const std::vector<std::size_t>& own) const
  {
    const Box moved(box.min() + by, box.max() + by);
    if (!inside(moved.center(), this->Cloth))
    {
      return 1 << 29;
    }
    int count = 0;
    for (const Segment& segment : this->Strokes)
    {
      count += enters(segment.from, segment.to, moved.min(), moved.max()) ? 1 : 0;
    }
    for (std::size_t k = 0; k < this->Piece.texts.size(); ++k)
    {
      const bool apart = !moved.intersects(boxOf(this->Piece.texts[k]));
      count += apart || std::find(own.begin(), own.end(), k) != own.end() ? 0 : 1;
    }
    return count;
  }

  PatternPiece& Piece;
  std::vector<Box> Pages; ///< what they show, in the coordinates of the piece
  Segments Strokes;
  Segments Cloth;
};
}

void keepTextsOnPages(const PagePlan& plan, Pattern& pattern)
{
  for (std::size_t p = 0; plan.pages.size() > 1 && p < pattern.pieces.size(); ++p)
  {
    PieceTexts(plan, plan.layout.corners[p], pattern.pieces[p]).keep();
  }
}
}
