// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/GarmentPieces.h"

#include "Imprint/ConstrainedDelaunay.h"
#include "Outlines/FairSpan.h"
#include "Outlines/Outline.h"
#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace flattening::pattern
{
namespace
{
/// Triangles between the corners of a polygon, counter-clockwise whatever its way round, by a
/// constrained Delaunay triangulation.
/// \param bad where it fails: the side, from the corner of that number, that crosses or touches
/// another
/// \return false where the polygon crosses or touches itself
bool triangulatePolygon(const Points2& polygon, Triangles& triangles, std::size_t& bad)
{
  constexpr double snap = 1e-9; // of the size
  const std::size_t count = polygon.size();
  const Box box = boxOf(polygon);
  // A triangle around the polygon, within which its sides are drawn.
  const double size = 4.0 * box.sizes().maxCoeff();
  const Point2 middle = box.center();
  const Point2 a = middle + size * Point2(-2.0, -1.0);
  const Point2 b = middle + size * Point2(2.0, -1.0);
  const Point2 c = middle + size * Point2(0.0, 2.0);
  const auto lift = [](const Point2& q) { return Point3(q.x(), q.y(), 0.0); };
  ConstrainedDelaunay mesh(lift(a), lift(b), lift(c), snap * size);
  const double area = cross(b - a, c - a);
  Indices cornerOf(3, none);
  Indices vertices;
  for (std::size_t k = 0; k < count; ++k)
  {
    const Point2& q = polygon[k];
    const double one = cross(c - b, q - b) / area;
    const double two = cross(a - c, q - c) / area;
    const Index vertex = mesh.addPoint({ one, two, 1.0 - one - two });
    if (static_cast<std::size_t>(vertex) != cornerOf.size())
    {
      bad = k;
      return false;
    }
    cornerOf.push_back(static_cast<Index>(k));
    vertices.push_back(vertex);
  }
  for (const bool drawn : { false, true })
  {
    for (std::size_t k = 0; k < count; ++k)
    {
      const Index from = vertices[k];
      const Index to = vertices[(k + 1) % count];
      if (drawn ? mesh.chain(from, to).size() != 2 : !mesh.addSegment(from, to))
      {
        bad = k;
        return false;
      }
    }
  }
  if (mesh.vertexCount() != static_cast<Index>(cornerOf.size()))
  {
    bad = 0;
    return false;
  }
  Segments sides;
  addSegments(polygon, true, sides);
  triangles.clear();
  for (const Triangle& triangle : mesh.triangles())
  {
    Triangle corners{};
    Point2 centre = Point2::Zero();
    bool outside = false;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = cornerOf[static_cast<std::size_t>(triangle[k])];
      outside = outside || corners[k] == none;
      centre += outside ? Point2(Point2::Zero())
                        : Point2(polygon[static_cast<std::size_t>(corners[k])] / 3.0);
    }
    if (!outside && inside(centre, sides))
    {
      triangles.push_back(corners);
    }
  }
  return true;
}

constexpr double chordDistance = 0.1 * sampleDistance; // centimetres per millimetre

class PieceMaking
{
  using Sides = std::array<GarmentSide, 2>;

public:
  PieceMaking(const Garment& garment, PatternSource& source)
    : Panels(garment)
    , Source(source)
  {
    for (const GarmentPanel& panel : garment.panels)
    {
      this->Chains.emplace_back(panel.edges.size());
      this->StitchOf.emplace_back(panel.edges.size(), garment.stitches.size());
    }
  }

  Status make()
  {
    for (std::size_t s = 0; s < this->Panels.stitches.size(); ++s)
    {
      for (const GarmentSide& side : this->Panels.stitches[s].sides)
      {
        this->StitchOf[side.panel][side.edge] = s;
      }
    }
    for (std::size_t p = 0; p < this->Panels.panels.size(); ++p)
    {
      this->addPoints(p);
      if (Status status = this->addTriangles(p); !status.ok())
      {
        return status;
      }
    }
    this->addSeams();
    this->addBoundary();
    this->Source.garment = this->Panels;
    return {};
  }

private:
  const GarmentEdge& edgeAt(const GarmentSide& side) const
  {
    return this->Panels.panels[side.panel].edges[side.edge];
  }
  Indices& chainOf(const GarmentSide& side) { return this->Chains[side.panel][side.edge]; }
  std::size_t stitchOf(const GarmentSide& side) const
  {
    return this->StitchOf[side.panel][side.edge];
  }
  bool isSewn(const GarmentSide& side) const
  {
    return this->stitchOf(side) < this->Panels.stitches.size();
  }
  /// Chords that an edge needs; both of a stitch have as many.
  std::size_t chordsOf(const GarmentSide& side) const
  {
    const auto ofOne = [this](const GarmentSide& one) {
      return pointsAlong(this->Panels.panels[one.panel], this->edgeAt(one), chordDistance, 1)
               .size() -
        1;
    };
    if (!this->isSewn(side))
    {
      return ofOne(side);
    }
    const GarmentStitch& stitch = this->Panels.stitches[this->stitchOf(side)];
    return std::max(ofOne(stitch.sides[0]), ofOne(stitch.sides[1]));
  }

  Index addPoint(const GarmentPanel& panel, const Point2& point)
  {
    this->Source.positions.push_back(point);
    this->Source.inSpace.push_back(placedPoint(panel, point));
    return static_cast<Index>(this->Source.positions.size()) - 1;
  }

  void addPoints(std::size_t p)
  {
    const GarmentPanel& panel = this->Panels.panels[p];
    std::set<std::size_t> used;
    for (const GarmentEdge& edge : panel.edges)
    {
      used.insert(edge.ends[0]);
    }
    Indices vertex(panel.vertices.size(), none);
    for (const std::size_t v : used)
    {
      vertex[v] = this->addPoint(panel, panel.vertices[v]);
    }
    for (std::size_t k = 0; k < panel.edges.size(); ++k)
    {
      const GarmentSide side{ p, k };
      const Points2 along = pointsAlong(panel, panel.edges[k], chordDistance, this->chordsOf(side));
      Indices& chain = this->chainOf(side);
      chain.push_back(vertex[panel.edges[k].ends[0]]);
      for (std::size_t n = 1; n + 1 < along.size(); ++n)
      {
        chain.push_back(this->addPoint(panel, along[n]));
      }
      chain.push_back(vertex[panel.edges[k].ends[1]]);
    }
  }

  Status addTriangles(std::size_t p)
  {
    const GarmentPanel& panel = this->Panels.panels[p];
    Indices points;
    std::vector<std::size_t> edgeOf;
    for (std::size_t k = 0; k < panel.edges.size(); ++k)
    {
      const Indices& chain = this->chainOf({ p, k });
      points.insert(points.end(), chain.begin(), chain.end() - 1);
      edgeOf.resize(points.size(), k);
    }
    Triangles triangles;
    std::size_t bad = 0;
    if (!triangulatePolygon(positionsOf(this->Source, points), triangles, bad))
    {
      return { StatusCode::InvalidPattern,
        edgeName(panel, edgeOf[bad]) + " crosses or touches the panel's border elsewhere" };
    }
    for (Triangle triangle : triangles)
    {
      for (Index& corner : triangle)
      {
        corner = points[static_cast<std::size_t>(corner)];
      }
      this->Source.triangles.push_back(triangle);
      this->Source.pieceOfTriangle.push_back(static_cast<Index>(p));
    }
    return {};
  }

  /// Adds points that begin where others end.
  static void append(const Indices& chain, Indices& points)
  {
    points.insert(points.end(), chain.begin() + (points.empty() ? 0 : 1), chain.end());
  }

  /// The edge before or behind one on its panel.
  GarmentSide beside(const GarmentSide& side, bool behind) const
  {
    const std::size_t count = this->Panels.panels[side.panel].edges.size();
    return { side.panel, (side.edge + (behind ? 1 : count - 1)) % count };
  }

  /// An edge and the one that it is sewn to.
  Sides sidesFrom(const GarmentSide& side) const
  {
    const Sides& sides = this->Panels.stitches[this->stitchOf(side)].sides;
    return sides[0] == side ? sides : Sides{ sides[1], sides[0] };
  }

  /// What goes on behind a stitch: the next edge of its first side, under the same labels sewn to
  /// the next edge of the other side. None where the seam ends.
  std::optional<Sides> onward(const Sides& sides) const
  {
    const std::size_t s = this->stitchOf(sides[0]);
    const bool rightToWrong = this->Panels.stitches[s].rightToWrong;
    const Sides next{ this->beside(sides[0], true), this->beside(sides[1], rightToWrong) };
    const std::size_t t = this->stitchOf(next[0]);
    const bool goesOn = this->isSewn(next[0]) && t == this->stitchOf(next[1]) && t != s &&
      !(next[0] == next[1]) && this->Panels.stitches[t].rightToWrong == rightToWrong &&
      this->edgeAt(next[0]).label == this->edgeAt(sides[0]).label &&
      this->edgeAt(next[1]).label == this->edgeAt(sides[1]).label;
    return goesOn ? std::make_optional(next) : std::nullopt;
  }

  void addSeams()
  {
    std::vector<char> done(this->Panels.stitches.size(), 0);
    for (std::size_t s = 0; s < this->Panels.stitches.size(); ++s)
    {
      if (done[s])
      {
        continue;
      }
      // Back to where the seam begins, unless it is a ring.
      Sides sides = this->Panels.stitches[s].sides;
      for (;;)
      {
        const GarmentSide before = this->beside(sides[0], false);
        if (!this->isSewn(before) || this->stitchOf(before) == s || done[this->stitchOf(before)] ||
          !this->onward(this->sidesFrom(before)))
        {
          break;
        }
        sides = this->sidesFrom(before);
      }
      this->addSeam(sides, done);
    }
  }

  /// Adds the two sides of a seam and what is sewn together along it.
  void addSeam(Sides sides, std::vector<char>& done)
  {
    const Index curve = this->Curves++;
    std::array<SourceWire, 2> wires;
    const std::string& label = this->edgeAt(sides[0]).label;
    const bool named = !label.empty() && label == this->edgeAt(sides[1]).label;
    for (std::optional<Sides> next = sides; next && !done[this->stitchOf((*next)[0])];
         next = this->onward(sides))
    {
      sides = *next;
      done[this->stitchOf(sides[0])] = 1;
      const Indices& a = this->chainOf(sides[0]);
      Indices b = this->chainOf(sides[1]);
      if (!this->Panels.stitches[this->stitchOf(sides[0])].rightToWrong)
      {
        std::reverse(b.begin(), b.end());
      }
      for (std::size_t k = 0; k + 1 < a.size(); ++k)
      {
        this->Source.sewn.push_back({ { a[k], a[k + 1] }, { b[k], b[k + 1] }, false });
      }
      append(a, wires[0].points);
      append(b, wires[1].points);
    }
    // The legs of a dart end in one point.
    const bool fold = wires[0].points.back() == wires[1].points.back() ||
      wires[0].points.front() == wires[1].points.front();
    for (std::size_t k = 0; k < 2; ++k)
    {
      wires[k].type = fold ? WireType::Dart : WireType::Seam;
      wires[k].curve = curve;
      wires[k].piece = static_cast<Index>(sides[k].panel);
      wires[k].name = named ? label : "stitch " + std::to_string(curve + 1);
      this->Source.wires.push_back(std::move(wires[k]));
    }
  }

  /// Adds what is not sewn: chains of edges with one label.
  void addBoundary()
  {
    for (std::size_t p = 0; p < this->Panels.panels.size(); ++p)
    {
      const std::vector<GarmentEdge>& edges = this->Panels.panels[p].edges;
      const std::size_t count = edges.size();
      const auto joined = [&](std::size_t k) {
        const GarmentSide side{ p, k % count };
        const GarmentSide before = this->beside(side, false);
        return !this->isSewn(side) && !this->isSewn(before) &&
          this->edgeAt(side).label == this->edgeAt(before).label;
      };
      std::size_t start = 0;
      while (start < count && joined(start))
      {
        ++start;
      }
      start = start < count ? start : 0; // a ring of one label begins at its first edge
      for (std::size_t k = start; k < start + count;)
      {
        const GarmentSide side{ p, k % count };
        SourceWire wire;
        wire.points = this->chainOf(side);
        for (++k; k < start + count && joined(k); ++k)
        {
          append(this->chainOf({ p, k % count }), wire.points);
        }
        if (this->isSewn(side))
        {
          continue;
        }
        const std::string& label = edges[side.edge].label;
        wire.piece = static_cast<Index>(p);
        wire.type = label.empty() ? WireType::Boundary : WireType::Accessory;
        wire.curve = label.empty() ? none : this->Curves++;
        wire.name = label.empty() ? "boundary" : label;
        this->Source.wires.push_back(std::move(wire));
      }
    }
  }

  const Garment& Panels;
  PatternSource& Source;
  // By panel and edge.
  std::vector<std::vector<Indices>> Chains; ///< the points along it
  std::vector<std::vector<std::size_t>> StitchOf;
  Index Curves = 0;
};
}

Status makePieces(const Garment& garment, PatternSource& source)
{
  source = PatternSource();
  Status status = checkGarment(garment);
  return status.ok() ? PieceMaking(garment, source).make() : status;
}
}
