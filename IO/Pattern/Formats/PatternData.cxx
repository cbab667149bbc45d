// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternData.h"

#include "Formats/FileAside.h"
#include "Formats/GarmentCodeFile.h"
#include "Outlines/Outline.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

namespace flattening::pattern
{
namespace
{
/// How far points of flat pieces may differ in z, as a share of their width.
constexpr double flatness = 1e-6;

/// Whether each array that is there has a value of its own for each of a number of rows.
Status checkRows(
  std::initializer_list<const Column*> arrays, std::size_t rows, const std::string& owner)
{
  for (const Column* const array : arrays)
  {
    if (array && (array->rows() < rows || array->components != 1))
    {
      return invalidPieces("the array " + array->name + " of " + owner + " has " +
        std::to_string(array->rows()) + " values of " + std::to_string(array->components) +
        " components for " + std::to_string(rows) + " rows");
    }
  }
  return {};
}

/// An array of numbers, or of texts; null where there is none.
const Column* arrayIn(const Columns& arrays, const char* name, bool isText = false)
{
  const Column* const found = findColumn(arrays, name);
  return found && found->isText() == isText ? found : nullptr;
}

/// A whole number that a value stands for; none where it stands for none, or for a negative one.
Index indexOf(double value)
{
  const bool fits = value >= 0.0 && value <= std::numeric_limits<Index>::max();
  return fits ? static_cast<Index>(value) : none;
}

/// A surface that was not flattened would be drawn as it is seen from above, not as it is cut.
Status checkFlatness(const Points3& points)
{
  Eigen::AlignedBox3d box;
  for (const Point3& p : points)
  {
    box.extend(p);
  }
  const double height = points.empty() ? 0.0 : box.sizes().z();
  const double size = points.empty() ? 0.0 : std::max(box.sizes().x(), box.sizes().y());
  if (!(height <= flatness * size))
  {
    return invalidPieces("the surface is not flat: it is " + std::to_string(height) +
      " high in z and " + std::to_string(size) + " wide");
  }
  return {};
}

Status readSurface(const DataSet& flat, PatternSource& source)
{
  const auto points = static_cast<std::int64_t>(flat.points->size());
  if (points > std::numeric_limits<Index>::max())
  {
    return invalidPieces("the flat surface has more points than 2^31 - 1");
  }
  Status status = checkFlatness(*flat.points);
  if (!status.ok())
  {
    return status;
  }
  for (const Point3& p : *flat.points)
  {
    source.positions.emplace_back(p.x(), p.y());
  }
  const Column* const pieces = arrayIn(flat.cellArrays, "PieceId");
  status = checkRows({ pieces }, flat.cells(), "the flat surface");
  if (!status.ok())
  {
    return status;
  }
  const Column* const names = arrayIn(flat.cellArrays, "PieceName", true);
  std::vector<std::optional<std::string>> nameOfPiece;
  const auto name = [&](std::size_t cell) {
    const Index piece = source.pieceOfTriangle.back();
    if (!names || cell >= names->rows() || piece < 0 ||
      static_cast<std::size_t>(piece) >= flat.cells())
    {
      return;
    }
    nameOfPiece.resize(std::max(nameOfPiece.size(), static_cast<std::size_t>(piece) + 1));
    std::optional<std::string>& one = nameOfPiece[static_cast<std::size_t>(piece)];
    const std::string own = names->text(cell);
    one = !one || *one == own ? own : std::string(); // cloth of two names has neither
  };
  for (std::size_t k = 0; k < flat.faces.size(); ++k)
  {
    const std::int64_t* const ids = flat.faces.begin(k);
    const std::size_t cell = flat.firstFace() + k;
    if (flat.faces.end(k) - ids != 3)
    {
      return invalidPieces(
        "cell " + std::to_string(cell) + " of the flat surface is not a triangle");
    }
    Triangle triangle{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      if (ids[c] < 0 || ids[c] >= points)
      {
        return invalidPieces("cell " + std::to_string(cell) + " of the flat surface uses point " +
          std::to_string(ids[c]) + ", which is not there");
      }
      triangle[c] = static_cast<Index>(ids[c]);
    }
    source.triangles.push_back(triangle);
    source.pieceOfTriangle.push_back(pieces ? indexOf(pieces->number(cell)) : 0);
    name(cell);
  }
  for (const std::optional<std::string>& one : nameOfPiece)
  {
    source.pieceNames.push_back(one.value_or(""));
  }
  return {};
}

WireType typeOf(const Column* types, std::size_t row)
{
  const double type = types ? types->number(row) : 0.0;
  const bool isKnown = type == -1.0 || (type >= 0.0 && type < 4.0);
  return isKnown ? static_cast<WireType>(static_cast<int>(type)) : WireType::Accessory;
}

Status readWires(const DataSet& wires, PatternSource& source)
{
  const auto points = static_cast<std::int64_t>(wires.points->size());
  if (wires.points->size() != source.positions.size())
  {
    return invalidPieces("the wires have " + std::to_string(points) +
      " points and the flat surface " + std::to_string(source.positions.size()));
  }
  const Columns& data = wires.cellArrays;
  const Column* const types = arrayIn(data, "CurveType");
  const Column* const curves = arrayIn(data, "CurveId");
  const Column* const pieces = arrayIn(data, "PieceId");
  const Column* const connectors = arrayIn(data, "Connector");
  const Column* const names = arrayIn(data, "CurveName", true);
  Status status =
    checkRows({ types, curves, pieces, connectors, names }, wires.cells(), "the wires");
  if (!status.ok())
  {
    return status;
  }
  for (std::size_t k = 0; k < wires.lines.size(); ++k)
  {
    const std::size_t row = wires.vertexCells + k;
    if (connectors && connectors->number(row) != 0.0)
    {
      continue; // an aid of the flattening, whose length is free
    }
    SourceWire wire;
    wire.type = typeOf(types, row);
    wire.curve = curves ? indexOf(curves->number(row)) : none;
    wire.piece = pieces ? indexOf(pieces->number(row)) : 0;
    wire.name = wire.type == WireType::Boundary ? std::string("boundary")
      : names                                   ? names->text(row)
                                                : "curve " + std::to_string(row);
    for (const std::int64_t* id = wires.lines.begin(k); id != wires.lines.end(k); ++id)
    {
      if (*id < 0 || *id >= points)
      {
        return invalidPieces("wire " + std::to_string(row) + " uses point " + std::to_string(*id) +
          ", which is not there");
      }
      wire.points.push_back(static_cast<Index>(*id));
    }
    source.wires.push_back(std::move(wire));
  }
  return {};
}

Status readSewnEdges(const DataSet& flat, PatternSource& source)
{
  const Column* const pairs = arrayIn(flat.fieldArrays, "SeamPairs");
  if (!pairs)
  {
    return {};
  }
  if (pairs->components < 4)
  {
    return invalidPieces("the array SeamPairs of the flat surface has fewer than 4 components");
  }
  const Column* const closed = arrayIn(flat.fieldArrays, "SeamClosed");
  if (Status status = checkRows({ closed }, pairs->rows(), "the flat surface"); !status.ok())
  {
    return status;
  }
  for (std::size_t row = 0; row < pairs->rows(); ++row)
  {
    std::array<Index, 4> ids{};
    for (int k = 0; k < 4; ++k)
    {
      const double id = pairs->number(row, k);
      if (!(id >= 0.0 && id < static_cast<double>(source.positions.size())))
      {
        return invalidPieces(
          "row " + std::to_string(row) + " of SeamPairs uses a point that is not there");
      }
      ids[static_cast<std::size_t>(k)] = static_cast<Index>(id);
    }
    const bool isClosed = closed && closed->number(row) != 0.0;
    source.sewn.push_back({ { ids[0], ids[1] }, { ids[2], ids[3] }, isClosed });
  }
  return {};
}

/// The panels that the pieces were; none where their text is not there.
Status readPanels(const DataSet& wires, PatternSource& source)
{
  const Column* const text = arrayIn(wires.fieldArrays, "GarmentCode", true);
  if (!text || text->rows() == 0)
  {
    return {};
  }
  Status status = parseGarmentCode(text->text(0), source.garment);
  const std::size_t panels = source.garment.panels.size();
  if (status.ok() && panels != pieceCount(source))
  {
    status = invalidPieces("there are " + std::to_string(panels));
  }
  return status.ok()
    ? status
    : invalidPieces("the panels of the wires do not fit the pieces: " + status.message);
}

Status readCutSurface(const DataSet& cut, PatternSource& source)
{
  if (cut.points->size() != source.positions.size())
  {
    return invalidPieces("the cut surface has " + std::to_string(cut.points->size()) +
      " points and the flat surface " + std::to_string(source.positions.size()));
  }
  source.inSpace = *cut.points;
  for (std::size_t v = 0; v < source.inSpace.size(); ++v)
  {
    if (!isFinite(source.inSpace[v]))
    {
      return invalidPieces("point " + std::to_string(v) + " of the cut surface is not finite");
    }
  }
  return {};
}

void setTime(Pattern& drawing)
{
  std::time_t now = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH"))
  {
    now = static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10));
  }
  std::tm parts{};
#ifdef _WIN32
  const bool known = gmtime_s(&parts, &now) == 0;
#else
  const bool known = gmtime_r(&now, &parts) != nullptr;
#endif
  char text[32];
  if (known && std::strftime(text, sizeof text, "%Y-%m-%d%H:%M", &parts) == 15)
  {
    drawing.date.assign(text, 10);
    drawing.time.assign(text + 10, 5);
  }
}
}

Status readPattern(
  const DataSet& flat, const DataSet* wires, const DataSet* cut, PatternSource& source)
{
  source = PatternSource();
  Status status = readSurface(flat, source);
  if (status.ok() && wires)
  {
    status = readWires(*wires, source);
    status = status.ok() ? readPanels(*wires, source) : status;
  }
  if (status.ok())
  {
    source.onCloth = arrayIn(flat.fieldArrays, "GrainAngle") != nullptr;
    source.isSheet = arrayIn(flat.fieldArrays, "SheetMaterial") != nullptr;
    status = readSewnEdges(flat, source);
  }
  if (status.ok() && cut)
  {
    status = readCutSurface(*cut, source);
  }
  return status;
}

Status writePattern(const std::string& path, const PatternSource& source,
  const FileOptions& options, Pattern& drawing)
{
  FileOptions file = options;
  file.format = file.format == FileFormat::Automatic ? formatOf(path) : file.format;
  if (file.format == FileFormat::Automatic)
  {
    return { StatusCode::InvalidOption, path + " ends with none of " + knownExtensions(), {},
      { Remedy::NameAnotherFile } };
  }
  setTime(drawing);
  std::string content;
  Status status = makePatternFile(source, file, drawing, content);
  if (!status.ok())
  {
    return status;
  }
  FileAside aside(path);
  status = aside.write(content);
  return status.ok() ? aside.publish() : status;
}
}
