// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with mixes of the defects that scanners and modelers leave: they are healed, and away
// from the defects lie in the plane as the clean surface does.
#include "../Core/MeshTriangles.h"
#include "Flattening/SurfaceFlattening.h"
#include "HostileSurface.h"
#include "Surface/SurfaceHealing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace hostile;

namespace
{
/// About this many triangles, where two functions of (0..1, 0..1) put them.
template <class Place>
Specimen sheetOf(const char* name, Index triangles, double aspect, const Place& place)
{
  Specimen sheet;
  sheet.name = name;
  const Index rows = static_cast<Index>(std::sqrt(0.5 * triangles / aspect));
  const Index columns = static_cast<Index>(0.5 * triangles / rows);
  for (Index j = 0; j <= rows; ++j)
  {
    for (Index i = 0; i <= columns; ++i)
    {
      sheet.points.push_back(
        place(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    }
  }
  sheet.triangles = testmeshes::gridTriangles(columns, rows);
  return sheet;
}

Specimen spiral(Index triangles)
{
  return sheetOf("spiral", triangles, 8.0, [](double u, double v) {
    const double turn = 2.0 + 10.0 * std::sqrt(u);
    const double radius = 0.05 * turn;
    return Point3(radius * std::cos(turn), radius * std::sin(turn), 0.3 * v);
  });
}

Specimen bumpySheet(Index triangles)
{
  return sheetOf("sheet", triangles, 1.0, [](double u, double v) {
    return Point3(u, v, 0.05 * std::sin(5.0 * u) * std::cos(4.0 * v) + 0.02 * std::sin(11.0 * v));
  });
}

/// Half a trouser leg that widens to a seat.
Specimen leg(Index triangles)
{
  return sheetOf("leg", triangles, 0.5, [](double u, double v) {
    const double angle = 2.6 * (u - 0.5);
    const double radius = 0.1 + 0.08 * v * v + 0.01 * std::sin(7.0 * v);
    return Point3(radius * std::sin(angle), v, radius * std::cos(angle));
  });
}

Specimen fineEnough(Specimen specimen, Index triangles)
{
  while (2 * static_cast<Index>(specimen.triangles.size()) < triangles)
  {
    refineSurface(specimen);
  }
  return specimen;
}

struct Flat
{
  HealedSurface surface;
  FlatteningResult result;
};

Flat flatten(const Specimen& specimen)
{
  Flat flat;
  flat.surface = healSurface(specimen.points, specimen.triangles);
  if (flat.surface.status.ok())
  {
    flat.result = flattenSurface(flat.surface.mesh, {}, {}, {});
  }
  return flat;
}

/// Damages a specimen and knows where.
class Damage
{
public:
  Damage(const Specimen& clean, unsigned seed)
    : Surface(clean)
    , Random(seed)
    , Clean(static_cast<Index>(clean.triangles.size()))
  {
    this->TrianglesAt.resize(clean.points.size());
    for (Index t = 0; t < this->Clean; ++t)
    {
      for (const Index p : clean.triangles[t])
      {
        this->TrianglesAt[p].push_back(t);
      }
    }
    for (const auto& [a, b, c] : clean.triangles)
    {
      this->Area += 0.5 * areaVector(clean.points[a], clean.points[b], clean.points[c]).norm();
    }
    const auto some = [this](Index share) { return 1 + this->below(1 + this->Clean / share); };
    // Each kind with three chances out of four, at triangles away from earlier damage.
    const auto kind = [&](Index share, void (Damage::*damage)(Index)) {
      const Index count = this->below(4) > 0 ? some(share) : 0;
      for (Index k = 0; k < count; ++k)
      {
        const Index t = damage == &Damage::addSpeck ? 0 : this->freeTriangle();
        if (t != none)
        {
          (this->*damage)(t);
        }
      }
    };
    kind(1000, &Damage::collapse);
    kind(2000, &Damage::insertFlat);
    kind(2000, &Damage::doubleTriangle);
    kind(5000, &Damage::turnPatch);
    kind(5000, &Damage::addSpeck);
    kind(2000, &Damage::addFin);
    kind(5000, &Damage::pinch);
    Indices order(this->Surface.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), this->Random);
    Triangles mixed;
    for (const Index t : order)
    {
      mixed.push_back(this->Surface.triangles[t]);
      this->OriginOf.push_back(t);
    }
    this->Surface.triangles = std::move(mixed);
  }

  const Specimen& surface() const { return this->Surface; }
  /// Of the clean surface; none for what the damage has added.
  Index cleanTriangle(Index t) const
  {
    return this->OriginOf[t] < this->Clean ? this->OriginOf[t] : none;
  }
  bool isPinched() const { return this->Pinched; }
  bool isNear(Index cleanTriangle) const { return this->Near.count(cleanTriangle) > 0; }

private:
  Index below(Index count)
  {
    return static_cast<Index>(this->Random() % static_cast<unsigned>(count));
  }
  /// A triangle away from damage so far, which then is near one.
  Index freeTriangle()
  {
    for (int attempt = 0; attempt < 200; ++attempt)
    {
      const Index t = this->below(this->Clean);
      if (!this->isNear(t))
      {
        Indices around;
        for (const Index p : this->Surface.triangles[t])
        {
          const Indices& at = this->TrianglesAt[p];
          around.insert(around.end(), at.begin(), at.end());
        }
        for (const Index neighbor : around)
        {
          for (const Index p : this->Surface.triangles[neighbor])
          {
            this->Near.insert(this->TrianglesAt[p].begin(), this->TrianglesAt[p].end());
          }
        }
        return t;
      }
    }
    return none;
  }
  bool isInside(Index p) const
  {
    std::map<Index, int> ends;
    for (const Index t : this->TrianglesAt[p])
    {
      for (const Index q : this->Surface.triangles[t])
      {
        ++ends[q];
      }
    }
    return std::all_of(ends.begin(), ends.end(), [](const auto& end) { return end.second != 1; });
  }
  Index addPoint(const Point3& p)
  {
    this->Surface.points.push_back(p);
    return static_cast<Index>(this->Surface.points.size()) - 1;
  }
  void collapse(Index t)
  {
    const Triangle& c = this->Surface.triangles[t];
    const Point3 edge = this->Surface.points[c[1]] - this->Surface.points[c[0]];
    const Point3 to = this->Surface.points[c[1]] - (this->below(2) > 0 ? 2e-7 : 0.0) * edge;
    this->Surface.points[c[0]] = to;
  }
  void insertFlat(Index t)
  {
    const auto [a, b, c] = this->Surface.triangles[t];
    const Point3 between = 0.5 * (this->Surface.points[a] + this->Surface.points[c]);
    const Index m = this->addPoint(between);
    this->Surface.triangles[t] = { a, b, m };
    this->Surface.triangles.push_back({ m, b, c });
    this->Surface.triangles.push_back({ a, m, c });
  }
  void doubleTriangle(Index t)
  {
    Triangle c = this->Surface.triangles[t];
    std::shuffle(c.begin(), c.end(), this->Random);
    this->Surface.triangles.push_back(c);
  }
  void turnPatch(Index t)
  {
    std::set<Index> patch;
    for (const Index p : this->Surface.triangles[t])
    {
      patch.insert(this->TrianglesAt[p].begin(), this->TrianglesAt[p].end());
    }
    for (const Index k : patch)
    {
      std::swap(this->Surface.triangles[k][0], this->Surface.triangles[k][1]);
    }
  }
  /// A triangle far off.
  void addSpeck(Index)
  {
    const double side = 0.03 * std::sqrt(this->Area);
    const Point3 at(10.0 * std::sqrt(this->Area) + this->below(100), 0.0, 0.0);
    const Index p = this->addPoint(at);
    this->addPoint(at + side * Point3::UnitX());
    this->addPoint(at + side * Point3::UnitY());
    this->Surface.triangles.push_back({ p, p + 1, p + 2 });
  }
  void addFin(Index t)
  {
    const Triangle c = this->Surface.triangles[t];
    if (this->isInside(c[0]))
    {
      const Points3& x = this->Surface.points;
      const Point3 normal = areaVector(x[c[0]], x[c[1]], x[c[2]]).normalized();
      const Point3 top = x[c[0]] + (x[c[1]] - x[c[0]]).norm() * normal;
      this->Surface.triangles.push_back({ c[0], c[1], this->addPoint(top) });
    }
  }
  /// Two triangles are missing that meet in an inner point only.
  void pinch(Index t)
  {
    const Triangle c = this->Surface.triangles[t];
    const Index p = c[0];
    const Indices& around = this->TrianglesAt[p];
    const auto meetsInPoint = [&](Index other) {
      const Triangle& corners = this->Surface.triangles[other];
      return std::count_if(corners.begin(), corners.end(),
               [&](Index q) { return std::find(c.begin(), c.end(), q) != c.end(); }) == 1;
    };
    const auto other = std::find_if(around.begin(), around.end(), meetsInPoint);
    if (this->isInside(p) && other != around.end())
    {
      this->Surface.triangles[t] = this->Surface.triangles[*other] = { p, p, p };
      this->Pinched = true;
    }
  }

  Specimen Surface;
  std::mt19937 Random;
  Index Clean;
  double Area = 0.0;
  bool Pinched = false;
  std::vector<Indices> TrianglesAt;
  std::set<Index> Near;
  Indices OriginOf;
};

/// Mean of |a - 1| over the triangles of a clean surface that are away from damage.
double areaError(const Flat& flat, const Specimen& given, const Damage& damage, bool isClean)
{
  double error = 0.0;
  double area = 0.0;
  for (std::size_t k = 0; k < flat.result.triangles.size(); ++k)
  {
    const Index cut = flat.result.cut->originalTriangle(static_cast<Index>(k));
    const Indices& origin = flat.surface.originalTriangle;
    const Index input = origin.empty() ? cut : origin[cut];
    const Index t = isClean ? input : damage.cleanTriangle(input);
    if (t != none && !damage.isNear(t))
    {
      const auto& [a, b, c] = given.triangles[input];
      const double own = 0.5 * areaVector(given.points[a], given.points[b], given.points[c]).norm();
      error += own * std::abs(flat.result.triangles[k].areaRatio - 1.0);
      area += own;
    }
  }
  return error / area;
}

void heal(unsigned first, unsigned count, Index triangles)
{
  std::vector<Specimen> specimens{ spiral(triangles), bumpySheet(triangles), leg(triangles) };
  for (const Specimen& data : dataSpecimens())
  {
    if (specimens.size() < 6 && data.name.find("front") != std::string::npos)
    {
      specimens.push_back(fineEnough(data, triangles));
    }
  }
  ASSERT_EQ(specimens.size(), 6U);
  std::vector<Flat> clean;
  for (const Specimen& specimen : specimens)
  {
    clean.push_back(flatten(specimen));
    ASSERT_TRUE(clean.back().surface.mendings.empty()) << specimen.name;
    ASSERT_EQ(clean.back().result.status.code, StatusCode::Ok)
      << specimen.name << ": " << clean.back().result.status.message;
  }
  std::set<SurfaceDefect> found;
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    const std::size_t which = seed % specimens.size();
    SCOPED_TRACE(specimens[which].name + ", seed " + std::to_string(seed));
    const Damage damage(specimens[which], seed);
    const Flat flat = flatten(damage.surface());
    ASSERT_TRUE(flat.surface.status.ok()) << flat.surface.status.message;
    for (const Mending& mending : flat.surface.mendings)
    {
      found.insert(mending.defect);
    }
    // The two vertices of a point in which the surface touched itself may pass each other.
    const StatusCode code = flat.result.status.code;
    EXPECT_TRUE(code == StatusCode::Ok || (code == StatusCode::Overlap && damage.isPinched()))
      << flat.result.status.message;
    ASSERT_EQ(flat.result.pieces.size(), 1U);
    EXPECT_TRUE(flat.result.pieces[0].quality.flipped.empty());
    const double before = areaError(clean[which], specimens[which], damage, true);
    EXPECT_NEAR(areaError(flat, damage.surface(), damage, false), before, 0.02 * before + 1e-3);
  }
  EXPECT_GE(found.size(), 7U);
}
}

TEST(VariedFewDefects, AreHealedOnEverySurface)
{
  heal(0, 12, 4000);
}

TEST(VariedDefects, AreHealedOnManySurfaces)
{
  heal(100, 1000, 10000);
}
