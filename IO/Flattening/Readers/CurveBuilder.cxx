// SPDX-License-Identifier: BSD-3-Clause
#include "CurveBuilder.h"

#include "BoundaryLoops.h"
#include "InputError.h"
#include "Paths/PlaneSection.h"
#include "Paths/StraightPath.h"
#include "Report/FlatteningData.h"
#include "Surface/EdgePaths.h"
#include "Surface/SurfacePreparation.h"
#include "TextFile.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace wirewarp
{
using flattening::Index;
using flattening::SurfacePoint;

namespace
{
/// How far the points of an edge may be from the boundary, as a fraction of the size of the
/// surface: coordinates may be rounded, or picked by hand.
constexpr double edgeTolerance = 5e-3;

/// A plane across an axis, and between which planes across axes its section is taken.
struct SectionPlane
{
  struct Bound
  {
    Eigen::Index axis = 0;
    double place = 0.0;
    bool above = true;
  };
  Eigen::Index axis = 0;
  double place = 0.0;
  std::vector<Bound> bounds = {};

  bool holds(const Point3& a, const Point3& b) const
  {
    return std::all_of(this->bounds.begin(), this->bounds.end(), [&](const Bound& bound) {
      const double middle = (a[bound.axis] + b[bound.axis]) / 2.0;
      return bound.above ? middle > bound.place : middle < bound.place;
    });
  }
};

/// "x=0", "z=120 y>0 x<30". None where the words are not of this form.
std::optional<SectionPlane> planeOf(std::string_view words)
{
  constexpr std::string_view axes = "xyz";
  SectionPlane plane;
  bool first = true;
  for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words))
  {
    const std::size_t axis = axes.find(word.front());
    const char sign = word.size() > 1 ? word[1] : ' ';
    double place = 0.0;
    if (axis == std::string_view::npos ||
      !parseNumber(word.substr(std::min<std::size_t>(2, word.size())), place) ||
      !std::isfinite(place) || (first ? sign != '=' : sign != '<' && sign != '>'))
    {
      return std::nullopt;
    }
    if (first)
    {
      plane.axis = static_cast<Eigen::Index>(axis);
      plane.place = place;
    }
    else
    {
      plane.bounds.push_back({ static_cast<Eigen::Index>(axis), place, sign == '>' });
    }
    first = false;
  }
  return first ? std::nullopt : std::optional(plane);
}

/// The stretches of a section within the bounds of its plane. A closed one is begun outside them.
void addStretches(const Points3& points, const SectionPlane& plane, std::vector<Points3>& lines)
{
  const std::size_t count = points.size() - 1;
  const auto holds = [&](std::size_t k) { return plane.holds(points[k], points[k + 1]); };
  std::size_t start = 0;
  while (points.front() == points.back() && start < count && holds(start))
  {
    ++start;
  }
  Points3 line;
  for (std::size_t k = start; k < start + count; ++k)
  {
    if (holds(k % count))
    {
      line.insert(line.end(), line.empty() ? 1 : 0, points[k % count]);
      line.push_back(points[k % count + 1]);
    }
    if (!line.empty() && (!holds(k % count) || k + 1 == start + count))
    {
      lines.push_back(std::move(line));
      line.clear();
    }
  }
}

/// "opening 2", "boundary left" and "boundary waist" are of one form.
bool isBoundaryWord(std::string_view word)
{
  return word == "opening" || word == "boundary";
}

/// The direction that a word names; right is along x.
std::optional<Point3> directionOf(std::string_view word, const TriangleList& list)
{
  const bool upIsY = flattening::upAxisOf(boxOf(list).sizes()) == 1;
  const Point3 up = upIsY ? Point3::UnitY() : Point3::UnitZ();
  const Point3 front = upIsY ? Point3(Point3::UnitZ()) : Point3(-Point3::UnitY());
  const std::map<std::string_view, Point3> directions{ { "left", -Point3::UnitX() },
    { "right", Point3::UnitX() }, { "top", up }, { "bottom", -up }, { "front", front },
    { "back", -front } };
  const auto found = directions.find(word);
  return found == directions.end() ? std::nullopt : std::optional(found->second);
}

/// The number of the opening whose points lie farthest in a direction, in the mean.
std::size_t farthest(
  const std::vector<BoundaryLoop>& all, const TriangleList& list, const Point3& direction)
{
  std::vector<double> along;
  for (const BoundaryLoop& loop : all)
  {
    double sum = 0.0;
    for (const std::int64_t point : loop.points)
    {
      sum += direction.dot(list.point(point));
    }
    along.push_back(sum / static_cast<double>(loop.points.size()));
  }
  return static_cast<std::size_t>(std::max_element(along.begin(), along.end()) - along.begin());
}

/// The surface as Core takes it, with what can be healed.
flattening::PreparedSurface preparedSurface(const DataSet& surface)
{
  DataSet healed;
  const bool mended = !flattening::healData(surface, healed).empty();
  const flattening::SurfaceTriangles read = flattening::readTriangles(mended ? healed : surface);
  flattening::PreparedSurface prepared = flattening::prepareSurface(read.points, read.triangles);
  if (!prepared.status.ok())
  {
    throw InputError(prepared.status.message);
  }
  return prepared;
}

/// Points of a curve on the surface, by the vertices next to them.
std::map<Index, SurfacePoint> endsOn(const flattening::TriangleMesh& mesh, const Points3& points)
{
  const flattening::SurfaceLocator locator(mesh);
  const flattening::SnapDistance snap(mesh, 1e-9);
  std::map<Index, SurfacePoint> ends;
  for (const Point3& point : points)
  {
    const flattening::ClosestPoint closest = locator.closest(point);
    const auto nearest = std::max_element(closest.weights.begin(), closest.weights.end());
    ends.emplace(mesh.triangle(closest.triangle)[nearest - closest.weights.begin()],
      flattening::snapToMesh(mesh, snap, closest));
  }
  return ends;
}

Points3 positionsOf(const flattening::SurfacePath& path, bool closed)
{
  Points3 places = flattening::positionsOf(path.points);
  places.back() = closed ? places.front() : places.back();
  return places;
}
}

RowType rowType(std::string_view word, const LineReader& lines)
{
  const bool isEdge = isEdgeWord(word);
  const auto kind = isEdge ? CurveKind() : curveKindOf(word);
  if (!kind)
  {
    lines.refuse("unknown curve type " + inQuotes(word) + "; use " + curveKindWords + ", or edge");
  }
  return { *kind, isEdge };
}

CurveBuilder::CurveBuilder(const LineReader& lines, const DataSet& surface, bool overSurface)
  : Lines(lines)
  , Surface(surface)
  , OverSurface(overSurface)
  , Points(overSurface ? surface.points : std::make_shared<const Points3>())
{
}

bool CurveBuilder::areWords(std::string_view text)
{
  const std::string_view first = takeWord(text);
  return first == "plane" || first == "between" || isBoundaryWord(first);
}

void CurveBuilder::addWords(const CurveTitle& title, bool isEdge, std::string_view words)
{
  try
  {
    for (const Line& line : this->linesOf(words, isEdge))
    {
      this->add(title, line);
    }
  }
  catch (const InputError& error)
  {
    this->Lines.refuse("curve " + inQuotes(title.name) + ": " + error.what());
  }
}

void CurveBuilder::addLine(const CurveTitle& title, const Points3& line)
{
  this->add(title, { line });
}

void CurveBuilder::addIds(
  const CurveTitle& title, bool isEdge, const std::vector<std::int64_t>& ids)
{
  if (!isEdge)
  {
    this->add(title, { this->placesOf(ids, this->places()), ids });
    return;
  }
  try
  {
    const std::vector<std::int64_t> way = this->borders().through(ids);
    this->add(title, { this->placesOf(way, *this->Surface.points), way });
  }
  catch (const InputError& error)
  {
    this->Lines.refuse("edge " + inQuotes(title.name) + ": " + error.what());
  }
}

void CurveBuilder::add(const CurveTitle& title, const Line& line)
{
  this->OverSurface && !line.ids.empty() ? this->Curves.add(line.ids, title)
                                         : this->Curves.add(line.points, this->added(), title);
  Points3& known = this->Known[title.name];
  known.insert(known.end(), line.points.begin(), line.points.end());
}

Points3& CurveBuilder::added()
{
  if (!this->Added)
  {
    this->Added = std::make_shared<Points3>(*this->Points);
  }
  return *this->Added;
}

std::int64_t CurveBuilder::newPoint(const Point3& place)
{
  this->added().push_back(place);
  return static_cast<std::int64_t>(this->Added->size()) - 1;
}

const BorderWays& CurveBuilder::borders()
{
  if (!this->Borders)
  {
    this->Borders.emplace(this->Surface);
  }
  return *this->Borders;
}

std::int64_t CurveBuilder::borderVertex(const Point3& place, const std::string& edge)
{
  double distance = 0.0;
  const std::int64_t vertex = this->borders().nearest(place, distance);
  if (vertex < 0)
  {
    this->Lines.refuse(
      "edge " + inQuotes(edge) + ": the surface has no boundary; make the curve accessory");
  }
  if (!(distance <= edgeTolerance * boxOf(*this->Surface.points).diagonal().norm()))
  {
    std::ostringstream text;
    text << "edge " << inQuotes(edge) << ": the point is " << distance
         << " off the boundary, at vertex " << vertex
         << " of it; give a point of the boundary, or make the curve accessory";
    this->Lines.refuse(text.str());
  }
  return vertex;
}

Points3 CurveBuilder::placesOf(const std::vector<std::int64_t>& ids, const Points3& points) const
{
  Points3 places;
  for (const std::int64_t id : ids)
  {
    places.push_back(points[static_cast<std::size_t>(id)]);
  }
  return places;
}

DataSet CurveBuilder::take()
{
  return this->Curves.over(this->Added ? this->Added : this->Points);
}

std::vector<CurveBuilder::Line> CurveBuilder::linesOf(std::string_view words, bool isEdge) const
{
  const std::string_view form = takeWord(words);
  if (isBoundaryWord(form))
  {
    return { this->boundary(words) };
  }
  if (isEdge)
  {
    throw InputError(
      "an edge lies along the boundary; write opening N, or make the curve accessory");
  }
  return form == "plane" ? this->sections(words) : std::vector<Line>{ this->between(words) };
}

CurveBuilder::Line CurveBuilder::boundary(std::string_view words) const
{
  const std::string word = takeName(words).value_or("");
  const auto known = this->Known.find(word);
  if (known != this->Known.end() && takeWord(words).empty())
  {
    return { known->second };
  }
  const TriangleList list = listTriangles(this->Surface);
  const std::vector<BoundaryLoop> all = openings(list);
  long long number = 0;
  const std::optional<Point3> direction = directionOf(word, list);
  if (direction && !all.empty())
  {
    number = static_cast<long long>(farthest(all, list, *direction)) + 1;
  }
  if ((!direction && !parseInteger(word, number)) || number < 1 || !takeWord(words).empty() ||
    number > static_cast<long long>(all.size()))
  {
    throw InputError("there is no such boundary; write opening N, N from 1 to " +
      std::to_string(all.size()) +
      " as wirewarp check lists them, or boundary left (right, top, bottom, front, back), or "
      "boundary and the name of a curve above this line");
  }
  std::vector<std::int64_t> vertices = all[static_cast<std::size_t>(number - 1)].points;
  vertices.push_back(vertices.front());
  return { this->placesOf(vertices, *this->Surface.points), vertices };
}

std::vector<CurveBuilder::Line> CurveBuilder::sections(std::string_view words) const
{
  const std::optional<SectionPlane> plane = planeOf(words);
  if (!plane)
  {
    throw InputError(
      "write plane x=NUMBER (or y, z), and behind it where it runs, as y>NUMBER z<NUMBER");
  }
  const flattening::PreparedSurface prepared = preparedSurface(this->Surface);
  const Point3 normal = Point3::Unit(plane->axis);
  std::vector<Points3> found;
  for (const flattening::PlaneSection& section :
    flattening::planeSections(prepared.mesh, plane->place * normal, normal))
  {
    if (section.path.points.size() > 1)
    {
      addStretches(positionsOf(section.path, section.closed), *plane, found);
    }
  }
  if (found.empty())
  {
    throw InputError("the plane does not meet the surface there; see its size with wirewarp check");
  }
  std::stable_sort(found.begin(), found.end(), [](const Points3& a, const Points3& b) {
    return flattening::polylineLength(a) > flattening::polylineLength(b);
  });
  std::vector<Line> lines;
  std::transform(found.begin(), found.end(), std::back_inserter(lines),
    [](Points3& points) { return Line{ std::move(points) }; });
  return lines;
}

/// An opening, or a curve by its name.
Points3 CurveBuilder::pointsOf(std::string_view& words) const
{
  const std::string name = takeName(words).value_or("");
  if (isBoundaryWord(name))
  {
    const std::string_view before = words;
    takeName(words);
    return this->boundary(before.substr(0, before.size() - words.size())).points;
  }
  const auto known = this->Known.find(name);
  if (known == this->Known.end())
  {
    throw InputError(
      "write between A and B; A and B are opening N, or names of curves above this line");
  }
  return known->second;
}

CurveBuilder::Line CurveBuilder::between(std::string_view words) const
{
  const Points3 first = this->pointsOf(words);
  const bool joined = takeWord(words) == "and";
  const Points3 second = this->pointsOf(words);
  if (!joined || !takeWord(words).empty())
  {
    throw InputError("write between A and B, with names of several words in quotes");
  }
  const flattening::PreparedSurface prepared = preparedSurface(this->Surface);
  const std::map<Index, SurfacePoint> starts = endsOn(prepared.mesh, first);
  const std::map<Index, SurfacePoint> ends = endsOn(prepared.mesh, second);
  flattening::Indices sources;
  for (const auto& [vertex, place] : starts)
  {
    sources.push_back(vertex);
  }
  const flattening::EdgePaths ways(
    prepared.mesh, sources, {}, flattening::EdgePaths::Through::Boundary);
  const auto nearest =
    std::min_element(ends.begin(), ends.end(), [&](const auto& a, const auto& b) {
      return std::pair(!ways.reaches(a.first), ways.distance(a.first)) <
        std::pair(!ways.reaches(b.first), ways.distance(b.first));
    });
  if (!ways.reaches(nearest->first) || ways.distance(nearest->first) == 0.0)
  {
    throw InputError(ways.reaches(nearest->first) ? "both meet; there is no way between them"
                                                  : "both lie on separate parts of the surface");
  }
  const flattening::PathGraph graph(prepared.mesh);
  const flattening::StraightPath path =
    flattening::straightPath(graph, starts.at(ways.path(nearest->first).front()), nearest->second);
  if (!path.status.ok())
  {
    throw InputError(path.status.message);
  }
  return { positionsOf(path.path, false) };
}
}
