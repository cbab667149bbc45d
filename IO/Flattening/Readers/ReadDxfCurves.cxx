// SPDX-License-Identifier: BSD-3-Clause
#include "ReadDxfCurves.h"

#include "InputError.h"
#include "TextFile.h"
#include "TriangleList.h"

#include "Base/Types.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
/// An entity of the section ENTITIES, or a VERTEX of one, with its groups in the order of the file.
/// Group codes: AutoCAD's "DXF Reference".
struct DxfEntity
{
  std::string kind; ///< of group 0
  std::string layer = "0";
  std::string handle;                                   ///< empty where the file has none
  std::size_t line = 0;                                 ///< of its kind, counted from 1
  std::vector<std::pair<int, double>> numbers;          ///< groups 10 to 79 and 210 to 239
  std::vector<std::pair<Point3, double>> vertices = {}; ///< of a POLYLINE, with their bulges

  std::vector<double> all(int code) const
  {
    std::vector<double> values;
    for (const auto& [other, value] : this->numbers)
    {
      values.insert(values.end(), other == code ? 1 : 0, value);
    }
    return values;
  }
  double number(int code, double otherwise) const
  {
    const std::vector<double> values = this->all(code);
    return values.empty() ? otherwise : values.front();
  }
  /// Points of the groups code, code + 10 and code + 20.
  Points3 places(int code) const
  {
    Points3 places;
    for (const auto& [other, value] : this->numbers)
    {
      if (other == code)
      {
        places.emplace_back(value, 0.0, 0.0);
      }
      else if ((other == code + 10 || other == code + 20) && !places.empty())
      {
        places.back()[other / 10 - 1] = value;
      }
    }
    return places;
  }
  /// Of group 70.
  bool hasFlag(long long flag) const
  {
    const double flags = this->number(70, 0.0);
    return std::abs(flags) < 1e9 && (static_cast<long long>(flags) & flag) != 0;
  }
};

/// An entity as a chain of points in the coordinates of the drawing. Arcs (bulges included) and
/// splines become chords that leave them by at most 1e-4 of the size of the entity. A spline is
/// computed by de Boor's algorithm from its control points, knots and weights. Entities of a plane
/// go from the coordinates of their extrusion (groups 210 to 230) to those of the drawing by the
/// "arbitrary axis algorithm" of the reference. What makes one throws InputError without the file
/// where the entity is defective.
struct DxfCourse
{
  Points3 places; ///< each once
  bool closed = false;
};

using Function = std::function<Point3(double)>;

/// How far chords leave a curve, as a fraction of the size of its entity.
constexpr double fineness = 1e-4;
/// Halvings of a part of a curve at most.
constexpr int mostHalvings = 10;

const double turn = 8.0 * std::atan(1.0);

double sizeOf(const Points3& places)
{
  return boxOf(places).diagonal().norm();
}

double distanceToChord(const Point3& place, const Point3& from, const Point3& to)
{
  return (from + flattening::fractionAlong(from, to, place) * (to - from) - place).norm();
}

/// Appends the chords of a function over an interval behind its first place, `from`.
void addChords(const Function& function, double begin, const Point3& from, double end,
  const Point3& to, double tolerance, int halvings, Points3& places)
{
  const auto isOff = [&](const Point3& place) {
    return distanceToChord(place, from, to) > tolerance;
  };
  const auto at = [&](double t) { return function(begin + t * (end - begin)); };
  const Point3 middle = at(0.5);
  if (halvings < mostHalvings && (isOff(at(0.25)) || isOff(middle) || isOff(at(0.75))))
  {
    const double half = 0.5 * (begin + end);
    addChords(function, begin, from, half, middle, tolerance, halvings + 1, places);
    addChords(function, half, middle, end, to, tolerance, halvings + 1, places);
    return;
  }
  places.push_back(to);
}

/// Appends the chords of a function from one end of an interval to the other, divided
/// so that no part turns so far that its quarters could lie on one chord.
void addChords(
  const Function& function, double begin, double end, int parts, double tolerance, Points3& places)
{
  const auto at = [&](int k) { return begin + (end - begin) * k / parts; };
  for (int k = 0; k < parts; ++k)
  {
    addChords(
      function, at(k), function(at(k)), at(k + 1), function(at(k + 1)), tolerance, 0, places);
  }
}

int quarters(double angle)
{
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (0.25 * turn) - 1e-9)));
}

/// The axes of the plane of an entity: of places in it, "object coordinates".
struct Plane
{
  Point3 x = Point3::UnitX();
  Point3 y = Point3::UnitY();
  Point3 z = Point3::UnitZ();

  explicit Plane(const DxfEntity& entity)
  {
    Point3 normal{ entity.number(210, 0.0), entity.number(220, 0.0), entity.number(230, 1.0) };
    if (!(normal.norm() > 0.0))
    {
      return;
    }
    normal.normalize();
    constexpr double nearZ = 1.0 / 64.0; // "arbitrary axis algorithm"
    const Point3 pole = std::abs(normal[0]) < nearZ && std::abs(normal[1]) < nearZ
      ? Point3(Point3::UnitY())
      : Point3(Point3::UnitZ());
    this->z = normal;
    this->x = pole.cross(this->z).normalized();
    this->y = this->z.cross(this->x).normalized();
  }

  Point3 inSpace(const Point3& place) const
  {
    return place[0] * this->x + place[1] * this->y + place[2] * this->z;
  }
};

/// Appends the way from one vertex of a polyline to the next. \param bulge the tangent of a quarter
/// of the angle of the arc, which turns left where it is positive.
void addSegment(
  const Point3& from, const Point3& to, double bulge, double tolerance, Points3& places)
{
  const double angle = 4.0 * std::atan(bulge);
  const Eigen::Vector2d chord = (to - from).head<2>();
  if (bulge == 0.0 || chord.isZero(0.0))
  {
    places.push_back(to);
    return;
  }
  const double side = 0.25 * (1.0 - bulge * bulge) / bulge; // of the center, in chords
  const Eigen::Vector2d arm = -0.5 * chord - side * Eigen::Vector2d(-chord.y(), chord.x());
  const Eigen::Vector2d center = from.head<2>() - arm;
  const auto arc = [&](double t) {
    Point3 place = from + t * (to - from);
    place.head<2>() = center + Eigen::Rotation2Dd(t * angle) * arm;
    return place;
  };
  addChords(arc, 0.0, 1.0, quarters(angle), tolerance, places);
  places.back() = to; // bit for bit, so that curves join
}

/// A closed course names its first place once.
DxfCourse closedOrOpen(Points3 places, bool closed)
{
  if (closed && places.size() > 1 &&
    (places.front() - places.back()).norm() <= 1e-9 * sizeOf(places))
  {
    places.pop_back();
  }
  return { std::move(places), closed };
}

DxfCourse bulgedCourse(
  const std::vector<std::pair<Point3, double>>& vertices, bool closed, const Plane& plane)
{
  if (vertices.empty())
  {
    return {};
  }
  Points3 corners;
  for (const auto& [place, bulge] : vertices)
  {
    corners.push_back(place);
  }
  Points3 places{ corners.front() };
  const double tolerance = fineness * sizeOf(corners);
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
  {
    addSegment(corners[k], corners[k + 1], vertices[k].second, tolerance, places);
  }
  if (closed && corners.size() > 1)
  {
    addSegment(corners.back(), corners.front(), vertices.back().second, tolerance, places);
  }
  for (Point3& place : places)
  {
    place = plane.inSpace(place);
  }
  return closedOrOpen(std::move(places), closed);
}

DxfCourse lightPolyline(const DxfEntity& entity)
{
  std::vector<std::pair<Point3, double>> vertices;
  const double elevation = entity.number(38, 0.0);
  for (const auto& [code, value] : entity.numbers)
  {
    if (code == 10)
    {
      vertices.emplace_back(Point3(value, 0.0, elevation), 0.0);
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
  std::vector<std::pair<Point3, double>> vertices = entity.vertices;
  const double elevation = entity.number(30, 0.0);
  for (auto& [place, bulge] : vertices)
  {
    place[2] = place[2] == 0.0 ? elevation : place[2];
  }
  return bulgedCourse(vertices, entity.hasFlag(1), Plane(entity));
}

/// Of the curve center + cos(t) x + sin(t) y.
DxfCourse ellipticArc(const Point3& center, const Point3& x, const Point3& y, double begin,
  double end, const DxfEntity& entity)
{
  const double size = 2.0 * std::max(x.norm(), y.norm());
  if (!(size > 0.0))
  {
    throw InputError("has no radius; draw it again");
  }
  const double whole = std::fmod(end - begin, turn);
  const double angle = whole <= 1e-9 ? whole + turn : whole;
  const bool closed = entity.kind == "CIRCLE" || std::abs(angle - turn) < 1e-6;
  const auto arc = [&](double t) -> Point3 { return center + std::cos(t) * x + std::sin(t) * y; };
  Points3 places{ arc(begin) };
  addChords(arc, begin, begin + (closed ? turn : angle), quarters(angle), fineness * size, places);
  return closedOrOpen(std::move(places), closed);
}

DxfCourse circularArc(const DxfEntity& entity)
{
  const Plane plane(entity);
  const Points3 centers = entity.places(10);
  const double radius = entity.number(40, 0.0);
  if (centers.empty())
  {
    throw InputError("has no center; draw it again");
  }
  const bool whole = entity.kind == "CIRCLE";
  const double degree = turn / 360.0;
  return ellipticArc(plane.inSpace(centers.front()), radius * plane.x, radius * plane.y,
    whole ? 0.0 : degree * entity.number(50, 0.0), whole ? turn : degree * entity.number(51, 360.0),
    entity);
}

DxfCourse ellipse(const DxfEntity& entity)
{
  const Plane plane(entity);
  const Points3 centers = entity.places(10);
  const Points3 axes = entity.places(11);
  if (centers.empty() || axes.empty())
  {
    throw InputError("has no center or no axis; draw it again");
  }
  return ellipticArc(centers.front(), axes.front(),
    entity.number(40, 1.0) * plane.z.cross(axes.front()), entity.number(41, 0.0),
    entity.number(42, turn), entity);
}

/// A B-spline in homogeneous coordinates.
struct Spline
{
  std::size_t degree = 3;
  std::vector<double> knots;
  std::vector<Eigen::Vector4d> points; ///< times their weights, and the weights

  /// De Boor's algorithm in the span of knots `span` to `span` + 1.
  Point3 at(double t, std::size_t span) const
  {
    const auto begin = this->points.begin() + static_cast<std::ptrdiff_t>(span - this->degree);
    std::vector<Eigen::Vector4d> work(begin, begin + static_cast<std::ptrdiff_t>(this->degree + 1));
    for (std::size_t r = 1; r <= this->degree; ++r)
    {
      for (std::size_t j = this->degree; j >= r; --j)
      {
        const double low = this->knots[span - this->degree + j];
        const double high = this->knots[span + 1 + j - r];
        const double part = (t - low) / (high - low);
        work[j] = (1.0 - part) * work[j - 1] + part * work[j];
      }
    }
    return work.back().head<3>() / work.back()[3];
  }
};

DxfCourse spline(const DxfEntity& entity)
{
  const Points3 controls = entity.places(10);
  const std::vector<double> weights = entity.all(41);
  const double degree = entity.number(71, 3.0);
  const std::size_t most = 25; // far above what programs draw
  if (controls.empty())
  {
    throw InputError("has no control points; save it as a spline of control points");
  }
  if (!(degree >= 1.0 && degree <= static_cast<double>(most)) ||
    controls.size() <= static_cast<std::size_t>(degree))
  {
    throw InputError("has " + std::to_string(controls.size()) +
      " control points, too few for its degree; draw it again");
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
    throw InputError("has knots or weights that do not fit its control points; draw it again");
  }
  for (std::size_t k = 0; k < controls.size(); ++k)
  {
    const double weight = weights.empty() ? 1.0 : weights[k];
    curve.points.emplace_back(weight * controls[k].homogeneous());
  }
  Points3 places;
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
    places.size() > 2 && (places.front() - places.back()).norm() <= 1e-9 * sizeOf(controls);
  return closedOrOpen(std::move(places), closed);
}

DxfCourse line(const DxfEntity& entity)
{
  Points3 places = entity.places(10);
  const Points3 ends = entity.places(11);
  places.insert(places.end(), ends.begin(), ends.end());
  return { std::move(places), false };
}

using CourseFunction = DxfCourse (*)(const DxfEntity&);

/// What makes a course of an entity; null where it is no curve.
CourseFunction functionOf(const DxfEntity& entity)
{
  static const std::map<std::string, CourseFunction> functions{ { "LINE", line },
    { "LWPOLYLINE", lightPolyline }, { "POLYLINE", polyline }, { "ARC", circularArc },
    { "CIRCLE", circularArc }, { "ELLIPSE", ellipse }, { "SPLINE", spline } };
  const auto found = functions.find(entity.kind);
  // 16 and 64: meshes of polygons
  const bool isMesh = entity.kind == "POLYLINE" && (entity.hasFlag(16) || entity.hasFlag(64));
  return found == functions.end() || isMesh ? nullptr : found->second;
}

constexpr const char* curveEntities = "LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE or SPLINE";

/// What a drawing says beside its lines.
bool isAnnotation(const std::string& kind)
{
  static constexpr std::array<std::string_view, 11> kinds{ "ATTDEF", "ATTRIB", "DIMENSION",
    "LEADER", "MTEXT", "MULTILEADER", "POINT", "SEQEND", "TEXT", "VERTEX", "VIEWPORT" };
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

std::string wordOf(const std::string& value)
{
  std::string_view rest(value);
  return std::string(takeWord(rest));
}

struct DxfReader
{
  DxfReader(const std::string& file, const std::string& text)
    : path(file)
    , lines(file, text, false)
  {
  }

  const std::string& path;
  LineReader lines;

  Points3 points;
  std::map<std::array<double, 3>, std::int64_t> pointAt;
  CurveList curves;
  DxfEntity entity;
  DxfEntity polyline; ///< whose vertices are on their way
  bool inPolyline = false;
  bool inEntities = false;
  std::map<std::string, std::vector<std::string>> unread; ///< places of entities, by their kinds

  double number(const std::string& value) const
  {
    double result = 0.0;
    if (!parseNumber(wordOf(value), result) || !std::isfinite(result))
    {
      this->lines.refuse(inQuotes(value) + " is not a number; save the DXF file as text again");
    }
    return result;
  }

  void addCurve(const DxfEntity& source)
  {
    DxfCourse course;
    try
    {
      course = functionOf(source)(source);
    }
    catch (const InputError& error)
    {
      throw InputError(
        this->path, source.line, "the " + source.kind + " " + std::string(error.what()));
    }
    if (course.places.size() < 2)
    {
      return;
    }
    std::vector<std::int64_t> ids;
    for (const Point3& place : course.places)
    {
      const auto [known, added] =
        this->pointAt.emplace(std::array<double, 3>{ place.x(), place.y(), place.z() },
          static_cast<std::int64_t>(this->points.size())); // so that lines join
      if (added)
      {
        this->points.push_back(place);
      }
      ids.push_back(known->second);
    }
    if (course.closed)
    {
      ids.push_back(ids.front());
    }
    this->curves.add(ids, curveTitle(source.layer));
  }

  void leaveOut(const DxfEntity& source)
  {
    this->unread[source.kind].push_back("line " + std::to_string(source.line) +
      (source.handle.empty() ? "" : ", handle " + source.handle));
  }

  /// What the next entity's beginning ends.
  void endEntity()
  {
    if (!this->inEntities)
    {
      this->entity = {};
      return;
    }
    if (this->entity.kind == "VERTEX" && this->inPolyline)
    {
      const Points3 places = this->entity.places(10);
      // 16: a point of the frame of a spline, beside the points on the spline.
      if (!places.empty() && !this->entity.hasFlag(16))
      {
        this->polyline.vertices.emplace_back(places.front(), this->entity.number(42, 0.0));
      }
    }
    else if (this->entity.kind == "SEQEND" && this->inPolyline)
    {
      this->addCurve(this->polyline);
      this->inPolyline = false;
    }
    else if (this->entity.kind == "POLYLINE" && functionOf(this->entity))
    {
      this->inPolyline = true;
      this->polyline = this->entity;
    }
    else if (functionOf(this->entity))
    {
      this->addCurve(this->entity);
    }
    else if (this->entity.kind != "SECTION" && !isAnnotation(this->entity.kind))
    {
      this->leaveOut(this->entity);
    }
    this->entity = {};
  }

  void readGroup(long long code, const std::string& value)
  {
    if (code == 8)
    {
      this->entity.layer = value;
    }
    else if (code == 5)
    {
      this->entity.handle = wordOf(value);
    }
    else if ((code >= 10 && code < 80) || (code >= 210 && code < 240))
    {
      this->entity.numbers.emplace_back(static_cast<int>(code), this->number(value));
    }
  }

  void read()
  {
    std::string code;
    std::string value;
    while (this->lines.next(code) && this->lines.next(value))
    {
      long long group = 0;
      if (!parseInteger(wordOf(code), group))
      {
        this->lines.refuse(
          inQuotes(code) + " is not a group code; the file may be binary DXF or be damaged");
      }
      if (group == 0)
      {
        this->endEntity();
        this->entity.kind = wordOf(value);
        this->entity.line = this->lines.number();
        this->inEntities = this->inEntities && this->entity.kind != "ENDSEC";
      }
      else if (group == 2 && this->entity.kind == "SECTION")
      {
        this->inEntities = value.find("ENTITIES") != std::string::npos;
      }
      else if (this->inEntities)
      {
        this->readGroup(group, value);
      }
    }
    this->endEntity();
  }

  /// "HATCH (line 12, handle 2F; line 40), INSERT (line 60)"
  std::string listUnread() const
  {
    constexpr std::size_t most = 3; // of a kind
    std::string text;
    for (const auto& [kind, places] : this->unread)
    {
      text += (text.empty() ? "" : ", ") + kind + " (";
      for (std::size_t k = 0; k < std::min(most, places.size()); ++k)
      {
        text += (k == 0 ? "" : "; ") + places[k];
      }
      text +=
        places.size() > most ? "; and " + std::to_string(places.size() - most) + " more)" : ")";
    }
    return text;
  }
};
}

CurveContents readDxfCurves(const std::string& path)
{
  const std::string text = readWholeFile(path);
  DxfReader reader(path, text);
  reader.read();
  const std::string unread = reader.listUnread();
  if (reader.curves.empty())
  {
    throw InputError(path,
      std::string("has no ") + curveEntities + " among its entities" +
        (unread.empty() ? "" : ", but " + unread) + "; draw the feature curves so");
  }
  return { reader.curves.over(std::make_shared<const Points3>(std::move(reader.points))),
    unread.empty()
      ? ""
      : "not read: " + unread + "; explode blocks, and draw feature curves as " + curveEntities };
}
}
