// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Types.h"
#include "Input/DataSet.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

namespace flattening
{
namespace
{
/// Segments joined end to end.
struct SegmentChain
{
  std::vector<std::int64_t> points; ///< the first again at the end where the chain is closed
  std::size_t firstSegment = 0;     ///< the smallest index of its segments
};

/// Joins segments wherever two of them, and no more, meet in a point. A chain runs in the direction
/// of its first segment; chains come in the order of their first segments.
std::vector<SegmentChain> chainSegments(const std::vector<std::array<std::int64_t, 2>>& segments)
{
  std::map<std::int64_t, std::vector<std::size_t>> segmentsAt;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    segmentsAt[segments[s][0]].push_back(s);
    segmentsAt[segments[s][1]].push_back(s);
  }
  std::vector<char> used(segments.size(), 0);
  // Goes on from the last point as long as there is one way.
  auto extend = [&](std::vector<std::int64_t>& points) {
    for (;;)
    {
      const std::int64_t end = points.back();
      const std::vector<std::size_t>& here = segmentsAt[end];
      if (here.size() != 2 || (used[here[0]] && used[here[1]]))
      {
        return;
      }
      const std::size_t s = used[here[0]] ? here[1] : here[0];
      used[s] = 1;
      points.push_back(segments[s][0] == end ? segments[s][1] : segments[s][0]);
    }
  };
  std::vector<SegmentChain> chains;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    if (used[s])
    {
      continue;
    }
    used[s] = 1;
    std::vector<std::int64_t> forward{ segments[s][1] };
    std::vector<std::int64_t> backward{ segments[s][0] };
    extend(forward);
    extend(backward);
    SegmentChain chain;
    chain.firstSegment = s;
    chain.points.assign(backward.rbegin(), backward.rend());
    chain.points.insert(chain.points.end(), forward.begin(), forward.end());
    chains.push_back(std::move(chain));
  }
  return chains;
}

/// Compares what the arrays say of line cells.
struct ByAttributes
{
  static auto values(const Polyline& line)
  {
    return std::tie(
      line.type, line.name, line.keyShape, line.tolerance, line.ease.fraction, line.ease.piece);
  }
  bool operator()(const Polyline& a, const Polyline& b) const { return values(a) < values(b); }
};

bool sameButForCase(const std::string& a, const std::string& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

struct Chain
{
  std::int64_t cell = -1; ///< the first one
  Polyline attributes;    ///< without points
  std::vector<std::int64_t> points;
};

/// Reads the line cells of one data set.
class LineReader
{
public:
  LineReader(const DataSet& data, int source, CurveInput& curves)
    : Data(data)
    , Points(*data.points)
    , Source(source)
    , Curves(curves)
    , Choice(data)
  {
  }

  bool read() { return this->checkArrays() && this->collectChains() && this->appendPolylines(); }

private:
  bool refuse(Status status)
  {
    this->Curves.outcome = std::move(status);
    this->Curves.blamed = this->Source;
    return false;
  }

  bool refuseCell(std::int64_t cell, const std::string& what, const char* suggested)
  {
    return this->refuse(refuseCurve(cell, what, suggested));
  }

  static ElementIds ofCell(std::int64_t cell)
  {
    return { ElementKind::Curves, std::vector<std::int64_t>{ cell } };
  }

  /// Null where there is none; warns of an array whose name differs in case alone.
  const Column* find(const Columns& arrays, const char* name)
  {
    const Column* const found = findColumn(arrays, name);
    for (const Column& other : arrays)
    {
      if (!found && sameButForCase(other.name, name))
      {
        this->Curves.warnings.push_back(
          "the array " + other.name + " of the curves is ignored; call it " + name);
      }
    }
    return found;
  }

  bool checkArrays()
  {
    const Columns& cells = this->Data.cellArrays;
    this->Type = this->find(cells, "CurveType");
    this->Name = this->find(cells, "CurveName");
    this->Shape = this->find(cells, "KeyShape");
    this->Tolerance = this->find(cells, "LengthTolerance");
    this->Ease = this->find(cells, "LengthEase");
    this->EasedPiece = this->find(cells, "EasedPiece");
    this->Planar = this->find(this->Data.pointArrays, "PlanarShape");
    for (const Column* const array :
      { this->Type, this->Name, this->Shape, this->Tolerance, this->Ease, this->EasedPiece })
    {
      if (!this->hasShape(array, 1, this->Data.cells(), "cell"))
      {
        return false;
      }
    }
    for (const Column* const array :
      { this->Shape, this->Tolerance, this->Ease, this->EasedPiece, this->Planar })
    {
      if (array && array->isText())
      {
        return this->refuse({ StatusCode::InvalidCurve,
          "the array " + array->name + " of the curves holds no numbers", {},
          { { Remedy::Give, "it as numbers" } } });
      }
    }
    return this->hasShape(this->Planar, 2, this->Points.size(), "point");
  }

  bool hasShape(const Column* array, int components, std::size_t tuples, const char* what)
  {
    if (!array || (array->components == components && array->rows() >= tuples))
    {
      return true;
    }
    return this->refuse({ StatusCode::InvalidCurve,
      "the array " + array->name + " of the curves has another shape", {},
      { { Remedy::Give,
        "it " + std::to_string(components) + (components == 1 ? " component" : " components") +
          " and a value for each " + what } } });
  }

  bool readType(std::int64_t cell, CurveType& type)
  {
    if (!this->Type)
    {
      return true;
    }
    const auto row = static_cast<std::size_t>(cell);
    for (const CurveType candidate :
      { CurveType::Accessory, CurveType::Key, CurveType::Dart, CurveType::Seam })
    {
      const bool equal = this->Type->isText()
        ? this->Type->text(row) == curveTypeName(candidate)
        : this->Type->number(row) == static_cast<int>(candidate);
      if (equal)
      {
        type = candidate;
        return true;
      }
    }
    return this->refuseCell(cell, "has the CurveType \"" + this->Type->text(row) + "\"",
      "0 (accessory), 1 (key), 2 (dart), 3 (seam) or one of these names");
  }

  bool readAttributes(std::int64_t cell, Polyline& attributes)
  {
    if (!this->readType(cell, attributes.type))
    {
      return false;
    }
    if (this->Name)
    {
      attributes.name = withoutNul(this->Name->text(static_cast<std::size_t>(cell)));
    }
    if (this->Shape)
    {
      const double shape = this->Shape->number(static_cast<std::size_t>(cell));
      if (shape != 0.0 && shape != 1.0)
      {
        return this->refuseCell(
          cell, "has an unknown KeyShape", "0 (as on the surface) or 1 (straight)");
      }
      attributes.keyShape = shape == 1.0 ? KeyShape::Straight : KeyShape::Surface;
    }
    if (this->Tolerance)
    {
      attributes.tolerance = this->Tolerance->number(static_cast<std::size_t>(cell));
      Status status = checkTolerance(cell, attributes.tolerance);
      if (!status.ok())
      {
        return this->refuse(std::move(status));
      }
    }
    return this->readEase(cell, attributes.ease);
  }

  bool readEase(std::int64_t cell, LengthEase& ease)
  {
    if (this->Ease)
    {
      ease.fraction = this->Ease->number(static_cast<std::size_t>(cell));
      if (!(std::abs(ease.fraction) < 1.0))
      {
        return this->refuseCell(
          cell, "has a LengthEase outside (-1, 1)", "a fraction of the length");
      }
    }
    if (this->EasedPiece)
    {
      const double piece = this->EasedPiece->number(static_cast<std::size_t>(cell));
      if (!(piece >= -1.0 && piece < std::numeric_limits<Index>::max() &&
            piece == std::floor(piece)))
      {
        return this->refuseCell(cell, "has an EasedPiece that is not the number of a piece",
          "the number of a piece from 0, or -1 for the only one");
      }
      ease.piece = static_cast<Index>(piece);
    }
    return true;
  }

  /// Polylines as they are; two-point lines that agree in their attributes joined end to end.
  bool collectChains()
  {
    if (this->Points.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    {
      return this->refuse({ StatusCode::InvalidOption, "the curves have too many points", {},
        { Remedy::DivideInput } });
    }
    bool sound = true;
    std::map<Polyline, std::vector<Chain>, ByAttributes> segments;
    const CellList& lines = this->Data.lines;
    for (std::size_t k = 0; k < lines.size() && sound; ++k)
    {
      Chain chain;
      chain.cell = static_cast<std::int64_t>(this->Data.vertexCells + k);
      if (!this->Choice.reads(this->Data.vertexCells + k))
      {
        continue;
      }
      chain.points.assign(lines.begin(k), lines.end(k));
      sound = this->checkPoints(chain) && this->readAttributes(chain.cell, chain.attributes);
      const bool segment = chain.points.size() == 2 && chain.points[0] != chain.points[1];
      if (sound && segment)
      {
        segments[chain.attributes].push_back(std::move(chain));
      }
      else if (sound)
      {
        this->Chains.push_back(std::move(chain));
      }
    }
    for (const auto& group : segments)
    {
      this->joinSegments(group.second);
    }
    std::stable_sort(this->Chains.begin(), this->Chains.end(),
      [](const Chain& a, const Chain& b) { return a.cell < b.cell; });
    return sound;
  }

  bool checkPoints(const Chain& chain)
  {
    const auto count = static_cast<std::int64_t>(this->Points.size());
    const bool known = std::all_of(chain.points.begin(), chain.points.end(),
      [count](std::int64_t p) { return p >= 0 && p < count; });
    return known ||
      this->refuse({ StatusCode::InvalidPointId,
        "cell " + std::to_string(chain.cell) + " of the curves uses a point id outside 0.." +
          std::to_string(count - 1),
        ofCell(chain.cell), { Remedy::WriteAgain } });
  }

  void joinSegments(const std::vector<Chain>& segments)
  {
    std::vector<std::array<std::int64_t, 2>> ends;
    ends.reserve(segments.size());
    for (const Chain& segment : segments)
    {
      ends.push_back({ segment.points[0], segment.points[1] });
    }
    for (SegmentChain& joined : chainSegments(ends))
    {
      Chain chain = segments[joined.firstSegment];
      chain.points = std::move(joined.points);
      this->Chains.push_back(std::move(chain));
    }
  }

  bool appendPolylines()
  {
    for (const Chain& chain : this->Chains)
    {
      Polyline polyline = chain.attributes;
      if (polyline.name.empty())
      {
        polyline.name = "curve " + std::to_string(this->Curves.polylines.size());
      }
      for (const std::int64_t p : chain.points)
      {
        polyline.points.push_back(this->Points[static_cast<std::size_t>(p)]);
        polyline.pointIds.push_back(static_cast<Index>(p));
      }
      if (!this->readPlanarShape(polyline))
      {
        return false;
      }
      this->Curves.polylines.push_back(std::move(polyline));
      this->Curves.cellOfPolyline.push_back(chain.cell);
      this->Curves.sourceOfPolyline.push_back(this->Source);
    }
    return true;
  }

  bool readPlanarShape(Polyline& polyline)
  {
    if (!this->Planar)
    {
      return true;
    }
    Points2 shape;
    for (const Index p : polyline.pointIds)
    {
      const auto row = static_cast<std::size_t>(p);
      shape.emplace_back(this->Planar->number(row, 0), this->Planar->number(row, 1));
    }
    Status status = takePlanarShape(shape, polyline);
    return status.ok() || this->refuse(std::move(status));
  }

  const DataSet& Data;
  const Points3& Points;
  int Source;
  CurveInput& Curves;
  CellChoice Choice;
  std::vector<Chain> Chains;
  const Column* Type = nullptr;
  const Column* Name = nullptr;
  const Column* Shape = nullptr;
  const Column* Tolerance = nullptr;
  const Column* Ease = nullptr;
  const Column* EasedPiece = nullptr;
  const Column* Planar = nullptr;
};
}

void readCurves(const DataSet& data, int source, CurveInput& curves)
{
  if (data.lines.size() > 0)
  {
    LineReader(data, source, curves).read();
  }
}
}
