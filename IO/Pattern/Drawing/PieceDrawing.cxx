// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PieceDrawing.h"

#include "Drawing/ClothOutline.h"
#include "Drawing/CurveNames.h"
#include "Fairing/FairBorders.h"
#include "Outlines/Grainlines.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace flattening::pattern
{
namespace
{
// Millimetres.
constexpr double worthSaying = 0.1; ///< gap between the legs of a dart that is reported
constexpr double leastRoom = 0.2;   ///< of a sew line from the cut line, for a notch between them

/// One piece while it is drawn.
struct PieceDrawer
{
  Status draw(const std::vector<BorderMark>& marks, const std::optional<PieceFold>& fold)
  {
    Status status = this->drawCutLine();
    if (!status.ok())
    {
      return status;
    }
    this->drawWires();
    for (std::size_t d = 0; d < this->Cloth.darts().size() && status.ok(); ++d)
    {
      status = this->Cloth.placement(d).check(this->Cloth.darts()[d].name, this->Drawing.name);
      this->drawDart(d);
    }
    if (!this->Misses.empty()) // of all darts in one sentence
    {
      this->Drawing.addNote(
        "folded, " + this->Misses + "; legs that are straight or mirrored do not");
    }
    if (!status.ok())
    {
      return status;
    }
    this->drawNotches();
    this->addGradePoints();
    for (const BorderMark& mark : marks)
    {
      if (mark.piece == this->Piece)
      {
        this->addBorderNotch(mark);
      }
    }
    const bool half = fold && !fold->isBorder;
    if (half)
    {
      keepRightHalf(fold->axis, this->Drawing);
    }
    else if (fold)
    {
      this->Drawing.lines.push_back(foldLine(this->Drawing.lines, fold->axis));
    }
    std::vector<JoinSide> joins = this->joinSides();
    if (half)
    {
      joins = rightHalf(joins, fold->axis);
      for (Points2& outline : this->Outlines)
      {
        outline = rightHalf(outline, fold->axis);
      }
    }
    const bool stands = this->standUp(fold, joins);
    for (const Points2& outline : this->Outlines)
    {
      addSegments(outline, true, this->Boundary);
    }
    drawGrainline(this->Boundary, this->All.source.onCloth, stands, this->Drawing);
    placeTexts(this->Boundary, joins, this->Drawing);
    // A cutter would cut twice.
    eraseIf(this->Drawing.lines, [](const PatternLine& line) { return line.isCut; });
    const Box box = boxOf(this->Drawing);
    forEachPoint(this->Drawing, [&box](Point2& p) { p -= box.min(); });
    this->Drawing.extent = box.sizes();
    return {};
  }

  /// Turns a piece that has no grain of its own so that the up of its surface is upright.
  /// \return whether there is one
  bool standUp(const std::optional<PieceFold>& fold, std::vector<JoinSide>& joins)
  {
    const PatternSource& source = this->All.source;
    // Rules of grading go along the axes of the flat pieces.
    if (source.onCloth || !source.gradePoints.empty() || hasStraightKey(this->Drawing))
    {
      return false;
    }
    std::optional<Point2> up = upOf(source, this->Piece, this->All.options.up);
    if (!up)
    {
      return false;
    }
    if (fold) // it is the grain, or across it
    {
      const Point2 along = fold->axis.along;
      const Point2 across(-along.y(), along.x());
      const Point2& nearest = std::abs(along.dot(*up)) > std::abs(across.dot(*up)) ? along : across;
      up = nearest.dot(*up) > 0.0 ? nearest : Point2(-nearest);
    }
    Eigen::Matrix2d turn;
    turn << up->y(), -up->x(), up->x(), up->y();
    const auto turned = [&turn](Point2& p) { p = turn * p; };
    forEachPoint(this->Drawing, turned);
    for (Points2& outline : this->Outlines)
    {
      std::for_each(outline.begin(), outline.end(), turned);
    }
    for (JoinSide& side : joins)
    {
      std::for_each(side.line.begin(), side.line.end(), turned);
    }
    return true;
  }

  Status drawCutLine()
  {
    for (const Indices& loop : this->Loops)
    {
      Points2 points;
      for (std::size_t k = 0; k < loop.size(); ++k)
      {
        addDrawnEdge(this->All, loop[k], loop[(k + 1) % loop.size()], points);
      }
      this->Outlines.push_back(std::move(points));
    }
    std::vector<Points2> borders;
    const std::vector<AllowancePolygon> polygons = this->Cloth.polygons();
    Status status = addAllowance(polygons, this->All.options.mitreLimit, borders);
    if (status.ok() && this->allowancesMeet(polygons))
    {
      this->Drawing.addNote("its allowances meet across a gap or a hole, which the cut line "
                            "closes; give a smaller allowance to keep it open");
    }
    // Then the cut line is the sew line, and keeps its curves.
    const bool bare = !hasAllowance(polygons) && this->Cloth.darts().empty();
    for (std::size_t b = 0; b < borders.size(); ++b)
    {
      addSegments(borders[b], true, this->CutLine);
      PatternLine line;
      line.kind = b == 0 ? LineKind::CutLine : LineKind::CutOut;
      line.closed = true;
      if (this->All.fair && bare)
      {
        SourceWire loop;
        loop.points = this->Loops[b];
        loop.points.push_back(loop.points.front());
        line.curve = this->All.fair->curveOf(loop);
      }
      line.points =
        this->All.fair && !bare ? thinned(borders[b], sampleDistance) : std::move(borders[b]);
      this->Drawing.lines.push_back(std::move(line));
    }
    return status;
  }

  /// Whether the cut line has another number of loops than the sew line, as it is drawn or with
  /// less allowance: what a closed gap encloses may be filled as well.
  bool allowancesMeet(std::vector<AllowancePolygon> polygons) const
  {
    std::vector<Points2> borders;
    for (int halving = 0; halving < 4 && hasAllowance(polygons); ++halving)
    {
      const Status status = addAllowance(polygons, this->All.options.mitreLimit, borders);
      if (status.ok() && borders.size() != polygons.size())
      {
        return true;
      }
      for (AllowancePolygon& polygon : polygons)
      {
        for (double& allowance : polygon.allowance)
        {
          allowance /= 2.0;
        }
      }
    }
    return false;
  }

  /// Whether a border is cut along itself, also near borders that have an allowance.
  bool isOnCutLine(const SourceWire& wire)
  {
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      const Points2 along = drawnLine(this->All, { wire.points[k], wire.points[k + 1] });
      if (this->All.allowanceAlong(wire.points[k], wire.points[k + 1]) > 0.0 ||
        std::any_of(along.begin(), along.end(),
          [this](const Point2& p) { return distance(p, this->CutLine) > 2.0 * sampleDistance; }))
      {
        return false;
      }
    }
    return wire.points.size() > 1;
  }

  LineKind kindOf(const SourceWire& wire)
  {
    switch (wire.type)
    {
      case WireType::Dart:
        return this->Cloth.placementAlong(wire.points[0], wire.points[1]) ? LineKind::DartLeg
                                                                          : LineKind::SewLine;
      case WireType::Key:
        return LineKind::KeyCurve;
      case WireType::Accessory:
        return areOnBorder(this->All.border, wire.points) &&
            this->All.options.foldsAlong.count(wire.name) == 0
          ? LineKind::SewLine
          : LineKind::Internal;
      default:
        return LineKind::SewLine;
    }
  }

  void drawWires()
  {
    const PatternSource& source = this->All.source;
    for (const SourceWire& wire : source.wires)
    {
      if (wire.piece != static_cast<Index>(this->Piece) || wire.points.size() < 2)
      {
        continue;
      }
      PatternLine line;
      line.kind = this->kindOf(wire);
      line.name = wire.type == WireType::Boundary ? "" : wire.name;
      line.points = this->All.at(wire.points);
      line.restLength = this->All.scale() * arcsOnSurface(source, wire.points).back();
      line.isCut = (line.kind == LineKind::SewLine || line.kind == LineKind::KeyCurve) &&
        areOnBorder(this->All.border, wire.points) && this->isOnCutLine(wire);
      if (this->All.fair)
      {
        line.curve = this->All.fair->curveOf(wire);
      }
      if (!line.curve.empty()) // it is where a wire has collapsed
      {
        line.points = sampled(line.curve);
      }
      if (line.kind == LineKind::DartLeg)
      {
        this->Cloth.placementAlong(wire.points[0], wire.points[1])->place(line);
      }
      if (wire.points.front() == wire.points.back())
      {
        line.closed = true;
        line.points.pop_back();
      }
      this->Drawing.lines.push_back(std::move(line));
    }
  }

  void drawDart(std::size_t d)
  {
    const Dart& dart = this->Cloth.darts()[d];
    const DartPlacement& placement = this->Cloth.placement(d);
    const Indices& loop = this->Loops[dart.loop];
    const std::size_t count = loop.size();
    const auto at = [&](std::size_t k) { return this->All.at(loop[k % count]); };
    const Point2 tip = placement.at(this->All.at(dart.tip));
    this->noteMiss(d);
    PatternLine fold;
    fold.kind = LineKind::DartFold;
    fold.name = dart.name;
    if (dart.otherTip != none)
    {
      fold.points = { tip, placement.at(this->All.at(dart.otherTip)) };
      this->addDrill(tip, fold.points[1]);
      this->addDrill(fold.points[1], tip);
    }
    else
    {
      const std::size_t end = dart.firstEdge + dart.edges;
      const Point2 middle = (at(dart.firstEdge) + at(end)) / 2.0;
      const Point2 direction = middle - tip;
      Point2 border = middle;
      for (const double s : crossings(tip, direction, this->CutLine))
      {
        if (s > 0.5 && dart.loop == 0) // the mouth of another one is at a cut inside
        {
          border = tip + s * direction;
          break;
        }
      }
      fold.points = { tip, border };
      this->addDrill(tip, middle);
      double length = 0.0;
      for (std::size_t k = end - dart.edges / 2; k < end; ++k)
      {
        length += (at(k + 1) - at(k)).norm();
      }
      this->addNotch(at(dart.firstEdge), (at(dart.firstEdge) - at(dart.firstEdge + 1)).normalized(),
        length, dart.name);
      this->addNotch(at(end), (at(end) - at(end - 1)).normalized(), length, dart.name);
    }
    this->Drawing.lines.push_back(std::move(fold));
  }

  /// Legs that are not mirror images fit when they are sewn, and not when they are folded.
  void noteMiss(std::size_t d)
  {
    const Dart& dart = this->Cloth.darts()[d];
    const DartPlacement& placement = this->Cloth.placement(d);
    const Indices& loop = this->Loops[dart.loop];
    Points2 legs;
    for (std::size_t k = dart.firstEdge; k <= dart.firstEdge + dart.edges; ++k)
    {
      legs.push_back(placement.at(this->All.at(loop[k % loop.size()])));
    }
    if (placement.back() > 0.0)
    {
      this->Drawing.addNote("the tip of " + dart.name + " is drawn back by " +
        formatNumber(placement.back(), 1) + " mm, of a depth of " +
        formatNumber(placement.depth(), 1) + " mm");
    }
    const double miss = foldMiss(legs);
    if (miss > worthSaying)
    {
      this->Misses += (this->Misses.empty() ? "the legs of " : ", of ") + dart.name +
        (this->Misses.empty() ? " miss each other by up to " : " by ") + formatNumber(miss, 1) +
        " mm";
    }
  }

  /// The hole stands back from the tip, so that the sewn dart hides it.
  void addDrill(const Point2& tip, const Point2& towards)
  {
    const double length = (towards - tip).norm();
    const double back = length > 0.0 ? std::min(10.0, 0.2 * length) / length : 0.0;
    this->Drawing.drillHoles.emplace_back(tip + back * (towards - tip));
  }

  void drawNotches()
  {
    const PatternSource& source = this->All.source;
    for (const NotchPlace& place : this->All.notches)
    {
      const Index from = place.edge[0];
      const Index to = place.edge[1];
      const auto border = this->All.border.find(edgeKey(from, to));
      if (!place.isDrawn || border == this->All.border.end() ||
        border->second != static_cast<Index>(this->Piece))
      {
        continue;
      }
      Point2 outward;
      const Point2 foot = pointOnDrawnEdge(this->All, from, to, place.fraction, outward);
      const std::string& name = source.wires[place.wire].name;
      const double arcLength = this->All.scale() * place.arcLength;
      const DartPlacement* const dart = this->Cloth.placementAlong(from, to);
      if (!dart)
      {
        this->addNotch(foot, outward, arcLength, name);
        continue;
      }
      // Across the leg, within the cloth.
      const Point2 placed = dart->at(foot);
      const Point2 half = std::min(this->All.options.notchLength, 5.0) / 2.0 *
        (dart->at(foot + outward) - placed).normalized();
      this->Drawing.notches.push_back(
        { placed, placed + half, placed - half, false, arcLength, name });
    }
  }

  /// Where a ray first meets the cut line; `from` where it does not.
  Point2 onCutLine(const Point2& from, const Point2& direction) const
  {
    for (const double at : crossings(from, direction, this->CutLine))
    {
      if (at > -1e-6)
      {
        return from + std::max(at, 0.0) * direction;
      }
    }
    return from;
  }

  /// A notch where a way from the sew line meets the cut line.
  void addNotch(
    const Point2& foot, const Point2& outward, double arcLength, const std::string& name)
  {
    const Point2 from = this->onCutLine(foot, outward);
    const double room = (from - foot).norm();
    // A cut into the allowance stays clear of the seam; without allowance it is a short mark.
    const double length =
      std::min(this->All.options.notchLength, room > leastRoom ? 0.6 * room : 3.0);
    this->Drawing.notches.push_back({ foot, from, from - length * outward, true, arcLength, name });
  }

  /// Where sew lines meet at a corner, both go on to the cut line; into a corner of the cloth and
  /// where a curve ends goes one notch.
  void addBorderNotch(const BorderMark& mark)
  {
    Point2 outOfFirst;
    Point2 outOfSecond;
    const Point2 foot = pointOnDrawnEdge(this->All, mark.before, mark.point, 1.0, outOfFirst);
    pointOnDrawnEdge(this->All, mark.point, mark.after, 0.0, outOfSecond);
    const double arcLength = this->All.scale() * mark.arcLength;
    if (!mark.corner || cross(outOfFirst, outOfSecond) <= 0.0)
    {
      this->addNotch(foot, (outOfFirst + outOfSecond).normalized(), arcLength, mark.name);
      return;
    }
    for (const Point2& onwards :
      { Point2(-outOfFirst.y(), outOfFirst.x()), Point2(outOfSecond.y(), -outOfSecond.x()) })
    {
      // Without an allowance the corner is mark enough.
      if ((this->onCutLine(foot, onwards) - foot).norm() > leastRoom)
      {
        this->addNotch(foot, onwards, arcLength, mark.name);
      }
    }
  }

  std::vector<JoinSide> sidesOf(std::size_t piece) const
  {
    std::vector<JoinSide> sides;
    for (const Join& join : this->All.joins)
    {
      for (std::size_t s = 0; s < 2; ++s)
      {
        if (this->All.options.joinMarks && !join.mark.empty() && join.piece[s] == piece)
        {
          sides.push_back({ join.mark, drawnLine(this->All, join.points[s]) });
        }
      }
    }
    return sides;
  }

  /// Of the piece, with the marks of its mirror image where that is not drawn: "A/B". These are
  /// told by the lengths of the sides.
  std::vector<JoinSide> joinSides() const
  {
    std::vector<JoinSide> sides = this->sidesOf(this->Piece);
    const std::vector<JoinSide> images =
      this->Image ? this->sidesOf(*this->Image) : std::vector<JoinSide>();
    for (JoinSide& side : sides)
    {
      const double length = polylineLength(side.line);
      std::map<std::string, double> misses; // by mark, the least
      for (const JoinSide& image : images)
      {
        const double miss = std::abs(polylineLength(image.line) - length);
        const auto known = misses.emplace(image.mark, miss).first;
        known->second = std::min(known->second, miss);
      }
      const auto byMiss = [](const auto& a, const auto& b) { return a.second < b.second; };
      const auto best = std::min_element(misses.begin(), misses.end(), byMiss);
      if (best == misses.end() || best->second > mirrorTolerance || best->first == side.mark)
      {
        continue;
      }
      const auto alike = [&best](const auto& one) {
        return one.first != best->first && one.second < 4.0 * best->second + 1e-3;
      };
      if (std::none_of(misses.begin(), misses.end(), alike))
      {
        side.mark.append("/").append(best->first);
      }
    }
    return sides;
  }

  void addGradePoints()
  {
    const Indices& graded = this->All.source.gradePoints;
    for (const Indices& loop : this->Loops)
    {
      for (std::size_t k = 0; k < graded.size(); ++k)
      {
        if (std::find(loop.begin(), loop.end(), graded[k]) != loop.end())
        {
          this->Drawing.gradePoints.push_back(
            { this->placeOf(graded[k]), static_cast<int>(k) + 1 });
        }
      }
    }
  }

  /// Where a point of a loop is drawn.
  Point2 placeOf(Index point)
  {
    for (std::size_t d = 0; d < this->Cloth.darts().size(); ++d)
    {
      const Dart& dart = this->Cloth.darts()[d];
      if (dart.tip == point || dart.otherTip == point)
      {
        return this->Cloth.placement(d).at(this->All.at(point));
      }
    }
    return this->All.at(point);
  }

  const DrawingSource& All;
  std::size_t Piece;
  /// A piece that is not drawn since it is this one's mirror image.
  std::optional<std::size_t> Image;
  PatternPiece& Drawing;
  const std::vector<Indices>& Loops = All.loops[Piece];
  ClothOutline Cloth{ All, Piece };
  std::vector<Points2> Outlines{}; ///< along the sew lines
  Segments Boundary{};             ///< of what is drawn
  Segments CutLine{};
  std::string Misses{}; ///< how far legs miss each other
};
}

Status drawPiece(const DrawingSource& all, std::size_t piece, std::optional<std::size_t> image,
  const std::vector<BorderMark>& marks, const std::optional<PieceFold>& fold, PatternPiece& drawing)
{
  return PieceDrawer{ all, piece, image, drawing }.draw(marks, fold);
}
}
