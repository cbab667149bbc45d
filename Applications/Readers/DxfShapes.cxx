// SPDX-License-Identifier: BSD-3-Clause
#include "DxfShapes.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wirewarp
{
namespace
{
using Places = std::vector<DxfPlace>;
using Function = std::function<DxfPlace(double)>;

/// How far chords leave a curve, as a fraction of the size of its entity.
constexpr double fineness = 1e-4;
/// Halvings of a part of a curve at most.
constexpr int mostHalvings = 10;

const double turn = 2.0 * vtkMath::Pi();

DxfPlace combined(const DxfPlace& a, double t, const DxfPlace& b)
{
  return { a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2] };
}

double distance(const DxfPlace& a, const DxfPlace& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

double sizeOf(const Places& places)
{
  DxfPlace low = places.front();
  DxfPlace high = low;
  for (const DxfPlace& place : places)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], place[k]);
      high[k] = std::max(high[k], place[k]);
    }
  }
  return distance(low, high);
}

double distanceToChord(const DxfPlace& place, const DxfPlace& from, const DxfPlace& to)
{
  const DxfPlace chord = combined(to, -1.0, from);
  const DxfPlace way = combined(place, -1.0, from);
  const double square = vtkMath::Dot(chord.data(), chord.data());
  const double t = square > 0.0 ? vtkMath::Dot(way.data(), chord.data()) / square : 0.0;
  return distance(place, combined(from, std::clamp(t, 0.0, 1.0), chord));
}

/// Chords of a function over an interval.
struct Chords
{
  const Function& function;
  double tolerance;
  Places& places;

  /// Appends the chords behind `from`.
  void add(double begin, const DxfPlace& from, double end, const DxfPlace& to, int halvings)
  {
    const auto at = [&](double t) { return this->function(begin + t * (end - begin)); };
    const DxfPlace middle = at(0.5);
    if (halvings < mostHalvings &&
      (distanceToChord(at(0.25), from, to) > this->tolerance ||
        distanceToChord(middle, from, to) > this->tolerance ||
        distanceToChord(at(0.75), from, to) > this->tolerance))
    {
      const double half = 0.5 * (begin + end);
      this->add(begin, from, half, middle, halvings + 1);
      this->add(half, middle, end, to, halvings + 1);
      return;
    }
    this->places.push_back(to);
  }
};

/// Appends the chords of a function from one end of an interval to the other, divided
/// so that no part turns so far that its quarters could lie on one chord.
void addChords(
  const Function& function, double begin, double end, int parts, double tolerance, Places& places)
{
  Chords chords{ function, tolerance, places };
  const auto at = [&](int k) { return begin + (end - begin) * k / parts; };
  for (int k = 0; k < parts; ++k)
  {
    chords.add(at(k), function(at(k)), at(k + 1), function(at(k + 1)), 0);
  }
}

int quarters(double angle)
{
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (0.25 * turn) - 1e-9)));
}

/// The axes of the plane of an entity: of places in it, "object coordinates".
struct Plane
{
  DxfPlace x{ 1.0, 0.0, 0.0 };
  DxfPlace y{ 0.0, 1.0, 0.0 };
  DxfPlace z{ 0.0, 0.0, 1.0 };

  explicit Plane(const DxfEntity& entity)
  {
    DxfPlace normal{ entity.number(210, 0.0), entity.number(220, 0.0), entity.number(230, 1.0) };
    if (vtkMath::Normalize(normal.data()) == 0.0)
    {
      return;
    }
    constexpr double nearZ = 1.0 / 64.0; // "arbitrary axis algorithm"
    const DxfPlace pole = std::abs(normal[0]) < nearZ && std::abs(normal[1]) < nearZ
      ? DxfPlace{ 0.0, 1.0, 0.0 }
      : DxfPlace{ 0.0, 0.0, 1.0 };
    this->z = normal;
    vtkMath::Cross(pole.data(), this->z.data(), this->x.data());
    vtkMath::Normalize(this->x.data());
    vtkMath::Cross(this->z.data(), this->x.data(), this->y.data());
    vtkMath::Normalize(this->y.data());
  }

  DxfPlace inSpace(const DxfPlace& place) const
  {
    const DxfPlace flat = combined(combined({}, place[0], this->x), place[1], this->y);
    return combined(flat, place[2], this->z);
  }
};

Places inSpace(const Plane& plane, Places places)
{
  for (DxfPlace& place : places)
  {
    place = plane.inSpace(place);
  }
  return places;
}

/// Appends the way from one vertex of a polyline to the next. \param bulge the tangent of a quarter
/// of the angle of the arc, which turns left where it is positive.
void addSegment(
  const DxfPlace& from, const DxfPlace& to, double bulge, double tolerance, Places& places)
{
  const double angle = 4.0 * std::atan(bulge);
  const double dx = to[0] - from[0];
  const double dy = to[1] - from[1];
  if (bulge == 0.0 || (dx == 0.0 && dy == 0.0))
  {
    places.push_back(to);
    return;
  }
  const double side = 0.25 * (1.0 - bulge * bulge) / bulge; // of the center, in chords
  const DxfPlace center{ from[0] + 0.5 * dx - side * dy, from[1] + 0.5 * dy + side * dx, 0.0 };
  const double rx = from[0] - center[0];
  const double ry = from[1] - center[1];
  const auto arc = [&](double t) {
    const double c = std::cos(t * angle);
    const double s = std::sin(t * angle);
    return DxfPlace{ center[0] + c * rx - s * ry, center[1] + s * rx + c * ry,
      from[2] + t * (to[2] - from[2]) };
  };
  addChords(arc, 0.0, 1.0, quarters(angle), tolerance, places);
  places.back() = to; // bit for bit, so that curves join
}

/// A closed course names its first place once.
DxfCourse closedOrOpen(Places places, bool closed)
{
  if (closed && places.size() > 1 &&
    distance(places.front(), places.back()) <= 1e-9 * sizeOf(places))
  {
    places.pop_back();
  }
  return { std::move(places), closed, {} };
}

DxfCourse bulgedCourse(
  const std::vector<std::pair<DxfPlace, double>>& vertices, bool closed, const Plane& plane)
{
  if (vertices.empty())
  {
    return {};
  }
  Places corners;
  for (const auto& [place, bulge] : vertices)
  {
    corners.push_back(place);
  }
  Places places{ corners.front() };
  const double tolerance = fineness * sizeOf(corners);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
  {
    addSegment(corners[k], corners[k + 1], vertices[k].second, tolerance, places);
  }
  if (closed && corners.size() > 1)
  {
    addSegment(corners.back(), corners.front(), vertices.back().second, tolerance, places);
  }
  return closedOrOpen(inSpace(plane, std::move(places)), closed);
}

DxfCourse lightPolyline(const DxfEntity& entity)
{
  std::vector<std::pair<DxfPlace, double>> vertices;
  const double elevation = entity.number(38, 0.0);
  for (const auto& [code, value] : entity.numbers)
  {
    if (code == 10)
    {
      vertices.push_back({ { value, 0.0, elevation }, 0.0 });
    }
    else if (code == 20 && !vertices.empty())
    {
      vertices.back().first[1] = value;
    }
    else if (code == 42 && !vertices.empty())
    {
      vertices.back().second = value;
    }
  }
  return bulgedCourse(vertices, entity.hasFlag(1), Plane(entity));
}

DxfCourse polyline(const DxfEntity& entity)
{
  if (entity.hasFlag(8)) // in space, without a plane
  {
    return bulgedCourse(entity.vertices, entity.hasFlag(1), Plane(DxfEntity()));
  }
  std::vector<std::pair<DxfPlace, double>> vertices = entity.vertices;
  const double elevation = entity.number(30, 0.0);
  for (auto& [place, bulge] : vertices)
  {
    place[2] = place[2] == 0.0 ? elevation : place[2];
  }
  return bulgedCourse(vertices, entity.hasFlag(1), Plane(entity));
}

/// Of the curve center + cos(t) x + sin(t) y.
DxfCourse ellipticArc(const DxfPlace& center, const DxfPlace& x, const DxfPlace& y, double begin,
  double end, const DxfEntity& entity)
{
  const double size = 2.0 * std::max(vtkMath::Norm(x.data()), vtkMath::Norm(y.data()));
  if (!(size > 0.0))
  {
    return { {}, false, "has no radius; draw it again" };
  }
  const double whole = std::fmod(end - begin, turn);
  const double angle = whole <= 1e-9 ? whole + turn : whole;
  const bool closed = entity.kind == "CIRCLE" || std::abs(angle - turn) < 1e-6;
  const auto arc = [&](double t) {
    return combined(combined(center, std::cos(t), x), std::sin(t), y);
  };
  Places places{ arc(begin) };
  addChords(arc, begin, begin + (closed ? turn : angle), quarters(angle), fineness * size, places);
  return closedOrOpen(std::move(places), closed);
}

DxfCourse circularArc(const DxfEntity& entity)
{
  const Plane plane(entity);
  const Places centers = entity.places(10);
  const double radius = entity.number(40, 0.0);
  if (centers.empty())
  {
    return { {}, false, "has no center; draw it again" };
  }
  const bool whole = entity.kind == "CIRCLE";
  const double degree = turn / 360.0;
  return ellipticArc(plane.inSpace(centers.front()), combined({}, radius, plane.x),
    combined({}, radius, plane.y), whole ? 0.0 : degree * entity.number(50, 0.0),
    whole ? turn : degree * entity.number(51, 360.0), entity);
}

DxfCourse ellipse(const DxfEntity& entity)
{
  const Plane plane(entity);
  const Places centers = entity.places(10);
  const Places axes = entity.places(11);
  if (centers.empty() || axes.empty())
  {
    return { {}, false, "has no center or no axis; draw it again" };
  }
  DxfPlace minor{};
  vtkMath::Cross(plane.z.data(), axes.front().data(), minor.data());
  return ellipticArc(centers.front(), axes.front(), combined({}, entity.number(40, 1.0), minor),
    entity.number(41, 0.0), entity.number(42, turn), entity);
}

/// A B-spline in homogeneous coordinates.
struct Spline
{
  std::size_t degree = 3;
  std::vector<double> knots;
  std::vector<std::array<double, 4>> points; ///< times their weights, and the weights

  /// De Boor's algorithm in the span of knots `span` to `span` + 1.
  DxfPlace at(double t, std::size_t span) const
  {
    const auto begin = this->points.begin() + static_cast<std::ptrdiff_t>(span - this->degree);
    std::vector<std::array<double, 4>> work(
      begin, begin + static_cast<std::ptrdiff_t>(this->degree + 1));
    for (std::size_t r = 1; r <= this->degree; ++r)
    {
      for (std::size_t j = this->degree; j >= r; --j)
      {
        const double low = this->knots[span - this->degree + j];
        const double high = this->knots[span + 1 + j - r];
        const double part = (t - low) / (high - low);
        for (std::size_t k = 0; k < 4; ++k)
        {
          work[j][k] = (1.0 - part) * work[j - 1][k] + part * work[j][k];
        }
      }
    }
    const std::array<double, 4>& end = work.back();
    return { end[0] / end[3], end[1] / end[3], end[2] / end[3] };
  }
};

DxfCourse spline(const DxfEntity& entity)
{
  const Places controls = entity.places(10);
  const std::vector<double> weights = entity.all(41);
  const double degree = entity.number(71, 3.0);
  const std::size_t most = 25; // far above what programs draw
  if (controls.empty())
  {
    return { {}, false, "has no control points; save it as a spline of control points" };
  }
  if (!(degree >= 1.0 && degree <= static_cast<double>(most)) ||
    controls.size() <= static_cast<std::size_t>(degree))
  {
    return { {}, false,
      "has " + std::to_string(controls.size()) +
        " control points, too few for its degree; draw it " + "again" };
  }
  Spline curve;
  curve.degree = static_cast<std::size_t>(degree);
  curve.knots = entity.all(40);
  if (curve.knots.size() != controls.size() + curve.degree + 1 ||
    !std::is_sorted(curve.knots.begin(), curve.knots.end()) ||
    !(curve.knots[curve.degree] < curve.knots[controls.size()]) ||
    (!weights.empty() && weights.size() != controls.size()) ||
    std::any_of(weights.begin(), weights.end(), [](double weight) { return !(weight > 0.0); }))
  {
    return { {}, false, "has knots or weights that do not fit its control points; draw it again" };
  }
  for (std::size_t k = 0; k < controls.size(); ++k)
  {
    const double weight = weights.empty() ? 1.0 : weights[k];
    const DxfPlace& place = controls[k];
    curve.points.push_back({ weight * place[0], weight * place[1], weight * place[2], weight });
  }
  Places places;
  for (std::size_t span = curve.degree; span < controls.size(); ++span)
  {
    const double begin = curve.knots[span];
    const double end = curve.knots[span + 1];
    if (!(begin < end))
    {
      continue;
    }
    const Function part = [&](double t) { return curve.at(t, span); };
    if (places.empty())
    {
      places.push_back(part(begin));
    }
    addChords(
      part, begin, end, static_cast<int>(curve.degree), fineness * sizeOf(controls), places);
  }
  const bool closed =
    places.size() > 2 && distance(places.front(), places.back()) <= 1e-9 * sizeOf(controls);
  return closedOrOpen(std::move(places), closed);
}

DxfCourse line(const DxfEntity& entity)
{
  Places places = entity.places(10);
  const Places ends = entity.places(11);
  places.insert(places.end(), ends.begin(), ends.end());
  return { std::move(places), false, {} };
}

using CourseFunction = DxfCourse (*)(const DxfEntity&);

CourseFunction functionOf(const DxfEntity& entity)
{
  static constexpr std::array<std::pair<const char*, CourseFunction>, 7> functions{
    { { "LINE", line }, { "LWPOLYLINE", lightPolyline }, { "POLYLINE", polyline },
      { "ARC", circularArc }, { "CIRCLE", circularArc }, { "ELLIPSE", ellipse },
      { "SPLINE", spline } }
  };
  const auto* const found = std::find_if(functions.begin(), functions.end(),
    [&](const auto& function) { return entity.kind == function.first; });
  return found == functions.end() ? nullptr : found->second;
}
}

//------------------------------------------------------------------------------
double DxfEntity::number(int code, double otherwise) const
{
  const auto found = std::find_if(this->numbers.begin(), this->numbers.end(),
    [code](const auto& group) { return group.first == code; });
  return found == this->numbers.end() ? otherwise : found->second;
}

//------------------------------------------------------------------------------
std::vector<double> DxfEntity::all(int code) const
{
  std::vector<double> values;
  for (const auto& [other, value] : this->numbers)
  {
    if (other == code)
    {
      values.push_back(value);
    }
  }
  return values;
}

//------------------------------------------------------------------------------
std::vector<DxfPlace> DxfEntity::places(int code) const
{
  std::vector<DxfPlace> places;
  for (const auto& [other, value] : this->numbers)
  {
    if (other == code)
    {
      places.push_back({ value, 0.0, 0.0 });
    }
    else if ((other == code + 10 || other == code + 20) && !places.empty())
    {
      places.back()[static_cast<std::size_t>(other / 10 - 1)] = value;
    }
  }
  return places;
}

//------------------------------------------------------------------------------
bool DxfEntity::hasFlag(long long flag) const
{
  const double flags = this->number(70, 0.0);
  return std::abs(flags) < 1e9 && (static_cast<long long>(flags) & flag) != 0;
}

//------------------------------------------------------------------------------
bool isDxfCurve(const DxfEntity& entity)
{
  // 16 and 64: meshes of polygons
  return functionOf(entity) &&
    !(entity.kind == "POLYLINE" && (entity.hasFlag(16) || entity.hasFlag(64)));
}

//------------------------------------------------------------------------------
DxfCourse courseOf(const DxfEntity& entity)
{
  return isDxfCurve(entity) ? functionOf(entity)(entity) : DxfCourse();
}
}
