// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/GarmentCodeFile.h"

#include "Base/Memory.h"
#include "Formats/GarmentPieces.h"
#include "Outlines/Outline.h"
#include "Outlines/PlaneGeometry.h"

#ifdef FLATTENING_WITH_JSON
#include "Input/JsonKeys.h"
#endif

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace flattening::pattern
{
namespace
{
Status invalid(const std::string& message)
{
  return { StatusCode::InvalidPattern, message };
}
}

#ifndef FLATTENING_WITH_JSON
Status parseGarmentCode(const std::string&, Garment& garment)
{
  garment = Garment();
  return invalid("it cannot be read: the library was built without nlohmann-json");
}
#else
namespace
{
using Json = nlohmann::ordered_json;

/// What is wrong with a document.
struct GarmentDefect
{
  std::string text;
};

void require(bool holds, const std::string& defect)
{
  if (!holds)
  {
    throw GarmentDefect{ defect };
  }
}

/// Takes a garment from a document. Throws GarmentDefect.
class GarmentReader
{
public:
  Garment read(const Json& document)
  {
    const Json& pattern = member(document, "pattern", "the file");
    const Json& panels = member(pattern, "panels", "the pattern");
    require(panels.is_object(), "the panels are not an object of panels by their names");
    this->readProperties(document);
    Garment garment;
    for (const auto& [name, panel] : panels.items())
    {
      this->Numbers[name] = garment.panels.size();
      this->readPanel(name, panel, garment.panels.emplace_back());
    }
    const auto stitches = pattern.find("stitches");
    if (stitches != pattern.end())
    {
      this->readStitches(*stitches, garment);
    }
    return garment;
  }

private:
  static const Json& member(const Json& object, const char* key, const std::string& owner)
  {
    require(object.is_object() && object.contains(key), owner + " has no member \"" + key + "\"");
    return object[key];
  }

  static double number(const Json& value, const std::string& what)
  {
    const double number = value.is_number() ? value.get<double>() : 0.0;
    require(value.is_number() && std::isfinite(number) && std::abs(number) <= 1e12,
      what + " is not a number, or is too large");
    return number;
  }

  template <typename Vector>
  static Vector vector(const Json& value, const std::string& what)
  {
    constexpr std::size_t size = Vector::SizeAtCompileTime;
    require(value.is_array() && value.size() == size,
      what + " is not a list of " + std::to_string(size) + " numbers");
    Vector result = Vector::Zero();
    for (std::size_t k = 0; k < size; ++k)
    {
      result[static_cast<Eigen::Index>(k)] = number(value[k], what);
    }
    return result;
  }

  static std::size_t index(const Json& value, const std::string& what)
  {
    require(value.is_number_unsigned() && value.get<std::uint64_t>() <= 1'000'000'000,
      what + " is not a whole number from 0");
    return value.get<std::size_t>();
  }

  static std::string label(const Json& object, const std::string& owner)
  {
    const auto found = object.find("label");
    if (found == object.end())
    {
      return {};
    }
    require(found->is_string(), "the label of " + owner + " is not text");
    return found->get<std::string>();
  }

  void readProperties(const Json& document)
  {
    const auto properties = document.find("properties");
    if (properties == document.end() || !properties->is_object())
    {
      return; // as their loader: in centimetres, relative
    }
    const auto unit = properties->find("units_in_meter");
    if (unit != properties->end())
    {
      const double perMetre = number(*unit, "units_in_meter");
      require(perMetre > 0.0, "units_in_meter must be above 0");
      this->Scale = 100.0 / perMetre; // exactly 1 where the file is in centimetres
    }
    const auto coordinates = properties->find("curvature_coords");
    if (coordinates != properties->end())
    {
      this->Absolute = *coordinates == "absolute";
      require(this->Absolute || *coordinates == "relative",
        "curvature_coords is neither \"relative\" nor \"absolute\"");
    }
  }

  void readPanel(const std::string& name, const Json& json, GarmentPanel& panel) const
  {
    panel.name = name;
    const std::string owner = "the panel " + name;
    const Json& vertices = member(json, "vertices", owner);
    const Json& edges = member(json, "edges", owner);
    require(
      vertices.is_array() && edges.is_array(), "vertices and edges of " + owner + " must be lists");
    panel.label = label(json, owner);
    if (json.contains("translation"))
    {
      panel.translation =
        this->Scale * vector<Point3>(json["translation"], "the translation of " + owner);
    }
    if (json.contains("rotation"))
    {
      panel.rotation = vector<Point3>(json["rotation"], "the rotation of " + owner);
    }
    for (const Json& vertex : vertices)
    {
      const std::string what = "vertex " + std::to_string(panel.vertices.size()) + " of " + owner;
      panel.vertices.emplace_back(this->Scale * vector<Point2>(vertex, what));
    }
    for (const Json& edge : edges)
    {
      this->readEdge(edge, panel);
    }
  }

  void readEdge(const Json& json, GarmentPanel& panel) const
  {
    const std::string owner = edgeName(panel, panel.edges.size());
    GarmentEdge& edge = panel.edges.emplace_back();
    const Json& ends = member(json, "endpoints", owner);
    require(ends.is_array() && ends.size() == 2, "the endpoints of " + owner + " are not two");
    for (const std::size_t k : { 0U, 1U })
    {
      edge.ends[k] = index(ends[k], "an end of " + owner);
      require(edge.ends[k] < panel.vertices.size(),
        owner + " ends at the vertex " + std::to_string(edge.ends[k]) + ", and there are " +
          std::to_string(panel.vertices.size()));
    }
    edge.label = label(json, owner);
    if (json.contains("curvature"))
    {
      this->readShape(json["curvature"], owner, panel, edge);
    }
  }

  void readShape(
    const Json& json, const std::string& owner, const GarmentPanel& panel, GarmentEdge& edge) const
  {
    if (json.is_array()) // of files before there were others
    {
      edge.shape = EdgeShape::Quadratic;
      this->addControl(json, owner, panel, 0, edge);
      return;
    }
    const std::string what = "the curvature of " + owner;
    const Json& type = member(json, "type", what);
    const Json& parameters = member(json, "params", what);
    const std::size_t wanted = type == "quadratic" ? 1 : type == "cubic" ? 2 : 3;
    require(wanted < 3 || type == "circle", what + " is neither quadratic, cubic nor circle");
    require(parameters.is_array() && parameters.size() == wanted,
      what + " has not the " + std::to_string(wanted) + " parameters");
    if (wanted < 3)
    {
      edge.shape = wanted == 1 ? EdgeShape::Quadratic : EdgeShape::Cubic;
      for (std::size_t k = 0; k < wanted; ++k)
      {
        this->addControl(parameters[k], owner, panel, 2 * k, edge);
      }
      return;
    }
    edge.shape = EdgeShape::Circle;
    edge.parameters[0] = this->Scale * number(parameters[0], "the radius of " + owner);
    for (const std::size_t k : { 1U, 2U })
    {
      const Json& flag = parameters[k];
      const bool isSet =
        flag.is_boolean() ? flag.get<bool>() : number(flag, "a flag of " + owner) != 0.0;
      edge.parameters[k] = isSet ? 1.0 : 0.0;
    }
  }

  void addControl(const Json& json, const std::string& owner, const GarmentPanel& panel,
    std::size_t at, GarmentEdge& edge) const
  {
    Point2 control = vector<Point2>(json, "a control point of " + owner);
    if (this->Absolute)
    {
      control = inFrameOf(
        this->Scale * control, panel.vertices[edge.ends[0]], panel.vertices[edge.ends[1]]);
    }
    edge.parameters[at] = control.x();
    edge.parameters[at + 1] = control.y();
  }

  void readStitches(const Json& json, Garment& garment) const
  {
    require(json.is_array(), "the stitches are not a list");
    for (const Json& stitch : json)
    {
      const std::string owner = "stitch " + std::to_string(garment.stitches.size());
      const bool marked = stitch.is_array() && stitch.size() == 3;
      require(stitch.is_array() && (stitch.size() == 2 || (marked && stitch[2].is_string())),
        owner + " does not name two edges");
      GarmentStitch& made = garment.stitches.emplace_back();
      made.rightToWrong = marked && stitch[2] == "right_wrong";
      for (const std::size_t k : { 0U, 1U })
      {
        const Json& name = member(stitch[k], "panel", owner);
        const Json& edge = member(stitch[k], "edge", owner);
        const auto panel =
          name.is_string() ? this->Numbers.find(name.get<std::string>()) : this->Numbers.end();
        require(panel != this->Numbers.end(),
          owner + " names the panel " + name.dump() + ", which is not there");
        made.sides[k] = { panel->second, index(edge, "an edge of " + owner) };
        const std::size_t edges = garment.panels[panel->second].edges.size();
        require(made.sides[k].edge < edges,
          owner + " names the edge " + edge.dump() + " of the panel " + panel->first +
            ", which has " + std::to_string(edges));
      }
    }
  }

  double Scale = 1.0;
  bool Absolute = false;
  std::map<std::string, std::size_t> Numbers;
};
}

Status parseGarmentCode(const std::string& text, Garment& garment)
{
  Status status;
  garment = Garment();
  try
  {
    const JsonFault fault =
      readJson<Json>(text, [&](const Json& json) { garment = GarmentReader().read(json); });
    status = fault.text.empty() ? checkGarment(garment) : invalid("it " + fault.text);
  }
  catch (const GarmentDefect& defect)
  {
    status = invalid(defect.text);
  }
  garment = status.ok() ? garment : Garment();
  return status;
}
#endif

namespace
{
Status readFile(const std::string& path, Garment& garment)
{
  constexpr std::uintmax_t largestFile = 100'000'000;
  std::error_code failed;
  if (!std::filesystem::is_regular_file(std::filesystem::u8path(path), failed))
  {
    return invalid("there is no file " + path);
  }
  if (std::filesystem::file_size(std::filesystem::u8path(path), failed) > largestFile || failed)
  {
    return invalid(path + " has more than 100 MB");
  }
  std::ifstream file(path, std::ios::binary);
  Status status = parseGarmentCode(
    { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() }, garment);
  status.message = status.ok() ? "" : path + ": " + status.message;
  return status;
}

/// The largest relative error of an edge's length.
double lengthError(const PatternSource& source, const SourceWire& wire)
{
  double error = 0.0;
  for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
  {
    const auto a = static_cast<std::size_t>(wire.points[k]);
    const auto b = static_cast<std::size_t>(wire.points[k + 1]);
    const double inSpace = (source.inSpace[b] - source.inSpace[a]).norm();
    const double inPlane = (source.positions[b] - source.positions[a]).norm();
    error = inSpace > 0.0 ? std::max(error, std::abs(inPlane - inSpace) / inSpace) : error;
  }
  return error;
}

/// Per pair of edges that are sewn together the curve, in the order of the sides that hold them.
Column seamPairs(const PatternSource& source)
{
  Indices curveOf;
  for (std::size_t w = 0; w + 1 < source.wires.size(); ++w)
  {
    const SourceWire& wire = source.wires[w];
    const bool first = (wire.type == WireType::Seam || wire.type == WireType::Dart) &&
      source.wires[w + 1].curve == wire.curve;
    for (std::size_t k = 0; first && k + 1 < wire.points.size(); ++k)
    {
      curveOf.push_back(wire.curve);
    }
  }
  std::vector<std::int64_t> pairs;
  for (std::size_t row = 0; row < source.sewn.size(); ++row)
  {
    const SewnEdges& sewn = source.sewn[row];
    pairs.insert(pairs.end(),
      { sewn.a[0], sewn.a[1], sewn.b[0], sewn.b[1], row < curveOf.size() ? curveOf[row] : none });
  }
  return { "SeamPairs", std::move(pairs), 5 };
}

Columns wireArrays(const PatternSource& source)
{
  Columns cells;
  const TableColumns<SourceWire> columns(cells, source.wires);
  columns.addAs<int>("CurveType", &SourceWire::type);
  columns.addAs<int>("WireKind", &SourceWire::type);
  cells.back().role = ArrayRole::Scalars;
  columns.addAs<std::int64_t>("CurveId", &SourceWire::curve);
  columns.addAs<std::int64_t>("PieceId", &SourceWire::piece);
  columns.add("CurveName", &SourceWire::name);
  columns.addAs<unsigned char>("Boundary", [](const SourceWire&) { return 1; });
  columns.addAs<unsigned char>("Connector", [](const SourceWire&) { return 0; });
  columns.add(
    "LengthError", [&source](const SourceWire& wire) { return lengthError(source, wire); });
  columns.add("RestLength",
    [&source](const SourceWire& wire) { return arcsOnSurface(source, wire.points).back(); });
  columns.add("FlatLength",
    [&source](const SourceWire& wire) { return polylineLength(positionsOf(source, wire.points)); });
  return cells;
}

GarmentData garmentData(const PatternSource& source)
{
  GarmentData data;
  Points3 inPlane;
  for (const Point2& p : source.positions)
  {
    inPlane.emplace_back(p.x(), p.y(), 0.0);
  }
  for (const Triangle& triangle : source.triangles)
  {
    data.flat.faces.add(triangle);
  }
  addRows<std::int64_t>(data.flat.cellArrays, "PieceId", source.triangles.size(),
    [&](std::size_t row) { return source.pieceOfTriangle[row]; });
  data.flat.cellArrays.back().role = ArrayRole::Scalars;
  data.cut = data.flat;
  data.flat.points = std::make_shared<const Points3>(std::move(inPlane));
  data.cut.points = std::make_shared<const Points3>(source.inSpace);
  Column pairs = seamPairs(source);
  if (pairs.rows() > 0)
  {
    data.flat.fieldArrays.push_back(std::move(pairs));
  }
  data.wires.points = data.flat.points;
  for (const SourceWire& wire : source.wires)
  {
    data.wires.lines.add(wire.points);
  }
  data.wires.cellArrays = wireArrays(source);
  setColumn(data.wires.fieldArrays,
    { "GarmentCode", std::vector<std::string>{ writeGarment(source.garment) } });
  return data;
}
}

Status readGarmentCode(const std::string& path, GarmentData& data)
{
  return withinMemory([&] {
    Garment garment;
    PatternSource source;
    Status status = readFile(path, garment);
    status = status.ok() ? makePieces(garment, source) : status;
    data = status.ok() ? garmentData(source) : GarmentData();
    return status;
  });
}
}
