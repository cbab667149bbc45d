// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CurveNames.h"

#include "Drawing/PatternStrokes.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening::pattern
{
namespace
{
constexpr double largestTitle = 8.0;
constexpr double longestName = 80.0; // letters, where the piece has no room for more

void placeTitle(const Segments& boundary, PatternPiece& piece)
{
  Segments obstacles{ { piece.grain.from, piece.grain.to } };
  for (const PatternLine& line : piece.lines)
  {
    if (!isCut(line.kind))
    {
      addSegments(line.points, line.closed, obstacles);
    }
  }
  double room = 0.0;
  Point2 center = widestPlace(boundary, obstacles, room);

  // A block of lines, the first one larger, that fits a circle of this radius at height 1.
  const double lineFeed = 1.4;
  double width = 0.0;
  double height = -0.4;
  for (std::size_t k = 0; k < piece.texts.size(); ++k)
  {
    const double size = k == 0 ? 1.0 : 0.7;
    width = std::max(width, textWidth(piece.texts[k].text, size));
    height += lineFeed * size;
  }
  const double radius = std::hypot(width, height) / 2.0;
  const double size =
    std::max(std::min(0.9 * room / radius, largestTitle), std::min(2.0, 0.5 * room));
  double y = center.y() + size * height / 2.0;
  for (std::size_t k = 0; k < piece.texts.size(); ++k)
  {
    PatternText& text = piece.texts[k];
    text.height = k == 0 ? size : 0.7 * size;
    // Nobody reads more, and a page with tens of thousands of letters takes seconds.
    text.text = fitText(
      text.text, text.height, std::max(2.0 * room, longestName * textWidth(".", text.height)));
    text.position = { center.x(), y - text.height / 2.0 };
    y -= lineFeed * text.height;
  }
}

constexpr double largestName = 3.0; // mm
constexpr double largestMark = 5.0;
constexpr double shortestMarked = 4.5;  // of a join with marks at its ends, in widths of its mark
constexpr double farthestMarks = 400.0; // of a join with one mark between its ends, mm
constexpr double mostPairs = 50.0;      // of marks between its ends, enough for 20 m
constexpr double leastReadable = 1.5;
constexpr double gap = 0.5;   // between name and line, in heights of the name
constexpr int outside = 1000; // as bad as that number of crossed lines
constexpr int onText = 100;   // likewise

/// A rectangle around a text.
struct TextBox
{
  Point2 center;
  Point2 along; ///< unit vector
  double halfWidth;
  double halfHeight;

  Point2 across() const { return { -this->along.y(), this->along.x() }; }

  bool meets(const Segment& segment) const
  {
    const auto within = [this](const Point2& p) {
      return Point2(this->along.dot(p - this->center), this->across().dot(p - this->center));
    };
    const Point2 half(this->halfWidth, this->halfHeight);
    return enters(within(segment.from), within(segment.to), -half, half);
  }

  void addTo(Segments& segments) const
  {
    const Point2 u = this->halfWidth * this->along;
    const Point2 v = this->halfHeight * this->across();
    const Points2 corners{ this->center - u - v, this->center + u - v, this->center + u + v,
      this->center - u + v };
    addSegments(corners, true, segments);
    segments.push_back({ corners[0], corners[2] });
    segments.push_back({ this->center - u, this->center + u });
  }
};

TextBox boxOf(const PatternText& text)
{
  return { text.position, { std::cos(text.angle), std::sin(text.angle) },
    0.5 * textWidth(text.text, text.height), 0.5 * text.height };
}

/// The points of a line from one arc length to another, both ends included.
Points2 partOf(const Points2& line, double from, double to)
{
  Points2 part;
  double arc = 0.0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
  {
    const Point2 way = line[k + 1] - line[k];
    const double edge = way.norm();
    if (edge == 0.0)
    {
      continue;
    }
    if (part.empty() && from <= arc + edge)
    {
      part.push_back(line[k] + std::max(0.0, from - arc) / edge * way);
    }
    if (!part.empty())
    {
      part.push_back(line[k] + std::min(1.0, (to - arc) / edge) * way);
      if (to <= arc + edge)
      {
        return part;
      }
    }
    arc += edge;
  }
  return part;
}

class NamePlacer
{
public:
  NamePlacer(const Segments& boundary, PatternPiece& piece)
    : Boundary(boundary)
    , Piece(piece)
    , Obstacles{ { piece.grain.from, piece.grain.to } }
  {
    for (const PatternLine& line : piece.lines)
    {
      addSegments(line.points, line.closed, this->Obstacles);
    }
    for (const Notch& notch : piece.notches)
    {
      this->Obstacles.push_back({ notch.from, notch.to });
    }
    for (const PatternText& text : piece.texts)
    {
      boxOf(text).addTo(this->Texts);
    }
    Box box;
    for (const Segment& segment : boundary)
    {
      box.extend(segment.from);
    }
    this->Size = boundary.empty() ? 0.0 : box.sizes().minCoeff();
  }

  /// A name that is marked as well is left out where it would lie on something, others where they
  /// would lie on a text.
  /// \param preferred where on the line to try first, as a fraction of its length
  /// \param onCloth within the sew lines
  void place(const std::string& name, const Points2& line, double preferred, bool onCloth = true,
    TextRole role = TextRole::Curve, bool marked = false)
  {
    const double length = polylineLength(line);
    PatternText text;
    text.role = role;
    text.text = name;
    text.height = std::min(largestName, 0.5 * length / textWidth(name, 1.0));
    const bool readable = text.height >= leastReadable;
    if (readable && !this->placeAt(text, line, preferred * length, 0.4 * length, onCloth, 0))
    {
      text.height = leastReadable;
      const int most = marked ? 0 : onText - 1;
      this->placeAt(text, line, preferred * length, 0.4 * length, onCloth, most);
    }
  }

  void placeMarks(const JoinSide& join)
  {
    const double length = polylineLength(join.line);
    PatternText text;
    text.role = TextRole::Join;
    text.text = join.mark;
    // A mark that is small is better than none.
    text.height =
      std::clamp(std::min(largestMark, 0.03 * this->Size + 1.0), leastReadable, largestMark);
    text.height = std::min(text.height, 0.7 * length / textWidth(join.mark, 1.0));
    if (!(text.height > 0.0))
    {
      return;
    }
    // In the middle, and of a long one in some places beside it.
    const int count = 1 + 2 * static_cast<int>(std::min(length / farthestMarks, mostPairs));
    for (int k = 0; k < count; ++k)
    {
      this->placeAt(
        text, join.line, (k + 0.5) / count * length, 0.25 * length / count, true, anything);
    }
    if (length < shortestMarked * textWidth(text.text, text.height))
    {
      return;
    }
    const double end = std::min(0.15 * length, 3.0 * text.height);
    for (const double at : { end, length - end })
    {
      this->placeAt(text, join.line, at, 0.5 * end, true, 0);
    }
  }

private:
  static constexpr int anything = std::numeric_limits<int>::max() - 1;

  /// \return whether it is placed
  /// \param reach how far the text may be from the preferred place, along the line
  /// \param most it is left out where it would cross more lines
  bool placeAt(
    PatternText text, const Points2& line, double preferred, double reach, bool onCloth, int most)
  {
    int best = std::numeric_limits<int>::max();
    for (int step = 0; step <= 20 && best > 0; ++step)
    {
      const int steps = (step + 1) / 2; // alternately before and behind
      const double where = preferred + 0.1 * reach * (step % 2 == 0 ? steps : -steps);
      for (const double side : { 1.0, -1.0 })
      {
        this->tryAt(line, where, side, onCloth, text, best);
      }
    }
    if (best % outside > most || best > anything)
    {
      return false;
    }
    boxOf(text).addTo(this->Texts);
    this->Piece.texts.push_back(std::move(text));
    return true;
  }

  /// Takes the place where it crosses fewer lines than the best so far.
  void tryAt(
    const Points2& line, double arc, double side, bool onCloth, PatternText& text, int& best) const
  {
    TextBox box = boxOf(text);
    const Points2 part = partOf(line, arc - box.halfWidth, arc + box.halfWidth);
    if (part.size() < 2 || (part.back() - part.front()).norm() == 0.0)
    {
      return;
    }
    box.along = (part.back() - part.front()).normalized();
    const Point2 out = side * box.across();
    double bulge = 0.0;
    for (const Point2& point : part)
    {
      bulge = std::max(bulge, out.dot(point - part.front()));
    }
    box.center =
      0.5 * (part.front() + part.back()) + (bulge + box.halfHeight + gap * text.height) * out;
    int crossed = !onCloth || inside(box.center, this->Boundary) ? 0 : outside;
    for (const Segment& obstacle : this->Obstacles)
    {
      crossed += box.meets(obstacle) ? 1 : 0;
    }
    const auto meets = [&box](const Segment& segment) { return box.meets(segment); };
    crossed += std::any_of(this->Texts.begin(), this->Texts.end(), meets) ? onText : 0;
    if (crossed < best)
    {
      best = crossed;
      text.position = box.center;
      // Readable from below or from the right.
      text.angle = std::atan2(box.along.y(), box.along.x());
      if (text.angle > 0.5 * pi + 1e-6)
      {
        text.angle -= pi;
      }
      else if (text.angle < -0.5 * pi + 1e-6)
      {
        text.angle += pi;
      }
    }
  }

  const Segments& Boundary;
  PatternPiece& Piece;
  Segments Obstacles;
  Segments Texts;    ///< around and across them
  double Size = 0.0; ///< the smaller extent of the piece
};
}

void placeTexts(const Segments& boundary, const std::vector<JoinSide>& joins, PatternPiece& piece)
{
  placeTitle(boundary, piece);
  NamePlacer placer(boundary, piece);
  for (const JoinSide& join : joins)
  {
    placer.placeMarks(join);
  }
  placeCurveNames(boundary, piece);
}

void placeCurveNames(const Segments& boundary, PatternPiece& piece)
{
  NamePlacer placer(boundary, piece);
  const bool marked = std::any_of(piece.texts.begin(), piece.texts.end(),
    [](const PatternText& text) { return text.role == TextRole::Join; });
  for (const PatternLine& line : piece.lines)
  {
    if (!line.name.empty() && line.points.size() > 1 && line.kind != LineKind::DartLeg)
    {
      // Off the middle, where curves like to cross each other and notches are.
      const bool sewn = line.kind == LineKind::SewLine;
      const bool fold = line.kind == LineKind::DartFold; // lies between the legs
      const double where = fold ? 0.55 : sewn ? 0.4 : 0.3;
      placer.place(line.name, line.points, where, !fold, TextRole::Curve, sewn && marked);
    }
  }
  const Grainline& grain = piece.grain;
  if (grain.from != grain.to)
  {
    placer.place(
      grain.known ? "grain" : "upright", { grain.from, grain.to }, 0.15, true, TextRole::Grain);
  }
}
}
