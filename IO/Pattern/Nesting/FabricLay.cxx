// SPDX-License-Identifier: BSD-3-Clause
#include "Nesting/FabricLay.h"

#include "Nesting/NoFitRegion.h"
#include "Outlines/Outline.h"
#include "Outlines/PatternText.h"
#include "Outlines/PlaneGeometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace flattening::pattern
{
namespace
{
/// In mm, 10 km: longer ones are an error of unit, and places are found on a grid of whole numbers.
constexpr double longestPiece = 1e7;

constexpr std::size_t mostPlacings = 4000; // of shapes, in all orders that are tried
constexpr std::size_t mostOrders = 300;
constexpr std::size_t mostCopies = 1000;

/// A motion of the plane that may turn a piece over.
using Motion = Eigen::Affine2d;

Points2 moved(Points2 points, const Motion& motion)
{
  for (Point2& p : points)
  {
    p = motion * p;
  }
  return points;
}

const PatternLine* cutLineOf(const PatternPiece& piece)
{
  const auto found = std::find_if(piece.lines.begin(), piece.lines.end(),
    [](const PatternLine& line) { return line.kind == LineKind::CutLine; });
  return found == piece.lines.end() ? nullptr : &*found;
}

/// The motion that lays the grain of a piece along y, up or down, with the cut line's bounding box
/// at the origin.
Motion motionOf(const PatternPiece& piece, bool turnedOver, bool upsideDown)
{
  Motion motion = Motion::Identity();
  const Point2 grain = piece.grain.to - piece.grain.from;
  const double length = grain.norm();
  const Point2 along = length > 0.0 ? Point2(grain / length) : Point2(0.0, 1.0);
  const double sign = upsideDown ? -1.0 : 1.0;
  // Rows: what becomes x, and y.
  motion.linear() << along.y(), -along.x(), along.x(), along.y();
  motion.linear() *= sign;
  if (turnedOver)
  {
    motion.linear().row(0) *= -1.0;
  }
  motion.translation() = -boxOf(moved(cutLineOf(piece)->points, motion)).min();
  return motion;
}

/// A copy of a piece where a motion brings it.
PatternPiece movedPiece(const PatternPiece& piece, const Motion& motion)
{
  PatternPiece copy = piece;
  forEachPoint(copy, [&motion](Point2& p) { p = motion * p; });
  // How many are cut is what lies on the cloth.
  eraseIf(copy.texts, [](const PatternText& text) {
    return text.role == TextRole::Label && text.text.rfind("cut ", 0) == 0;
  });
  const bool turnsOver = motion.linear().determinant() < 0.0;
  for (PatternText& text : copy.texts)
  {
    const Point2 along = motion.linear() * Point2(std::cos(text.angle), std::sin(text.angle));
    text.angle = std::atan2(along.y(), along.x());
    if (turnsOver && text.role == TextRole::Title)
    {
      text.text += ", turned over";
    }
    // Letters are never turned over; of a line they run from its other end.
    if (turnsOver && std::cos(text.angle) < 0.0)
    {
      text.angle += text.angle > 0.0 ? -pi : pi;
    }
  }
  copy.quantity = 1;
  copy.turnedOver = 0;
  copy.extent = boxOf(copy).max();
  return copy;
}

/// A piece, or one that is turned over, the ways it may lie, and how much of the cloth it takes.
struct Kind
{
  struct Way
  {
    Motion motion;
    std::size_t shape = 0;
  };
  std::size_t piece = 0;
  std::vector<Way> ways;
  Point2 extent = Point2::Zero();
  double area = 0.0;
};

struct Copy
{
  std::size_t way = 0;
  Point2 at = Point2::Zero();
};

struct Lay
{
  std::vector<Copy> copies;
  double length = 1e300;
};

/// Searches for a short lay.
struct LaySearch
{
  Status search()
  {
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      const PatternPiece& piece = this->Drawn.pieces[p];
      if (!cutLineOf(piece))
      {
        return { StatusCode::InvalidPattern, "piece " + piece.name + " has no cut line" };
      }
      const std::size_t copies =
        this->KindOf.size() + static_cast<std::size_t>(std::max(piece.quantity, 0));
      if (copies > mostCopies)
      {
        return { StatusCode::InvalidOption,
          "up to piece " + piece.name + " " + std::to_string(copies) +
            " pieces of cloth are to be laid, and no more than " + std::to_string(mostCopies) +
            " can be",
          {}, { { Remedy::Give, "a smaller quantity" } } };
      }
      this->addCopies(p, false, piece.quantity - piece.turnedOver);
      this->addCopies(p, true, piece.turnedOver);
      if (!this->fits(this->Kinds.back()))
      {
        return { StatusCode::PatternTooLarge,
          "piece " + piece.name + " is " + formatNumber(this->Kinds.back().extent.x(), 1) +
            " mm wide across its grain and " + formatNumber(this->Kinds.back().extent.y(), 1) +
            " mm long, and the cloth " + formatNumber(this->Options.width, 1) + " mm wide",
          {}, { { Remedy::Give, "a wider cloth, its width in millimeters, or another grain" } } };
      }
    }
    this->improve();
    return {};
  }

  const Kind& kindOf(std::size_t copy) const { return this->Kinds[this->KindOf[copy]]; }

  bool fits(const Kind& kind) const
  {
    return kind.extent.x() <= this->Options.width && kind.extent.y() <= longestPiece;
  }

  void addCopies(std::size_t p, bool turnedOver, int count)
  {
    if (count < 1)
    {
      return;
    }
    const PatternPiece& piece = this->Drawn.pieces[p];
    Kind kind;
    kind.piece = p;
    kind.area = std::abs(doubleArea(cutLineOf(piece)->points)) / 2.0;
    for (const bool upsideDown : { false, true })
    {
      if (upsideDown && this->Options.nap)
      {
        continue;
      }
      Kind::Way way;
      way.motion = motionOf(piece, turnedOver, upsideDown);
      Points2 polygon = moved(cutLineOf(piece)->points, way.motion);
      kind.extent = boxOf(polygon).max();
      if (!this->fits(kind))
      {
        this->Kinds.push_back(kind);
        return; // before it is beyond the grid of places
      }
      for (Point2& q : polygon) // on the sheet y points down
      {
        q.y() = kind.extent.y() - q.y();
      }
      way.shape = this->Region.addShape(polygon, this->Options.gap);
      kind.ways.push_back(way);
    }
    this->Kinds.push_back(kind);
    this->KindOf.insert(
      this->KindOf.end(), static_cast<std::size_t>(count), this->Kinds.size() - 1);
  }

  Lay layIn(const std::vector<std::size_t>& order)
  {
    Lay lay;
    lay.copies.resize(order.size());
    lay.length = 0.0;
    std::vector<NoFitRegion::Placed> there;
    for (const std::size_t copy : order)
    {
      const Kind& kind = this->kindOf(copy);
      double least = 1e300;
      for (std::size_t way = 0; way < kind.ways.size(); ++way)
      {
        const Point2 at = this->Region.lowest(there, kind.ways[way].shape, this->Options.width);
        ++this->Placings;
        const double price = at.y() + 1e-3 * at.x() / this->Options.width;
        if (price < least)
        {
          least = price;
          lay.copies[copy] = { way, at };
        }
      }
      const Copy& laid = lay.copies[copy];
      there.push_back({ kind.ways[laid.way].shape, laid.at });
      lay.length = std::max(lay.length, laid.at.y() + kind.extent.y());
    }
    return lay;
  }

  void improve()
  {
    std::vector<std::size_t> order(this->KindOf.size());
    std::iota(order.begin(), order.end(), std::size_t{ 0 });
    std::vector<std::size_t> bestOrder = order;
    const auto tryOrder = [&](const std::vector<std::size_t>& next) {
      Lay lay = this->layIn(next);
      if (lay.length < this->Best.length)
      {
        this->Best = std::move(lay);
        bestOrder = next;
      }
    };
    const std::array<double (*)(const Kind&), 3> sizes{ [](const Kind& k) { return k.area; },
      [](const Kind& k) { return k.extent.y(); }, [](const Kind& k) { return k.extent.x(); } };
    for (const auto size : sizes)
    {
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return size(this->kindOf(a)) > size(this->kindOf(b));
      });
      tryOrder(order);
    }
    // This generator, unlike the distributions, gives the same numbers on every machine.
    std::mt19937 random(1);
    const auto draw = [&random](
                        std::size_t count) { return static_cast<std::size_t>(random()) % count; };
    for (std::size_t k = 0; order.size() > 1 && k < mostOrders && this->Placings < mostPlacings;
         ++k)
    {
      std::vector<std::size_t> next = bestOrder;
      std::swap(next[draw(next.size())], next[draw(next.size())]);
      tryOrder(next);
    }
  }

  const FabricOptions& Options;
  const Pattern& Drawn;
  NoFitRegion Region{};
  std::vector<Kind> Kinds{};
  std::vector<std::size_t> KindOf{}; ///< of each copy
  std::size_t Placings = 0;
  Lay Best{};
};
}

Status layOnFabric(const FabricOptions& options, Pattern& pattern)
{
  LaySearch search{ options, pattern };
  if (Status status = search.search(); !status.ok())
  {
    return status;
  }
  Fabric fabric;
  fabric.width = options.width;
  fabric.length = search.Best.length;
  std::vector<PatternPiece> laid;
  double area = 0.0;
  for (std::size_t c = 0; c < search.Best.copies.size(); ++c)
  {
    const Kind& kind = search.kindOf(c);
    const Copy& copy = search.Best.copies[c];
    laid.push_back(movedPiece(pattern.pieces[kind.piece], kind.ways[copy.way].motion));
    fabric.corners.push_back(copy.at);
    area += kind.area;
  }
  fabric.efficiency = fabric.length > 0.0 ? area / (fabric.width * fabric.length) : 0.0;
  laid.front().notes.push_back({ "the cloth: " + formatNumber(fabric.width, 1) + " mm x " +
    formatNumber(fabric.length, 0) + " mm for " + std::to_string(laid.size()) +
    (laid.size() == 1 ? " piece, of which " : " pieces, of which ") +
    formatNumber(100.0 * fabric.efficiency, 1) + " % is used" });
  pattern.pieces = std::move(laid);
  pattern.fabric = std::move(fabric);
  return {};
}
}
