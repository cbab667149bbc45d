// SPDX-License-Identifier: BSD-3-Clause
#include "CurveInput.h"

#include "AttributeArrays.h"
#include "Base/Types.h"
#include "SurfaceInput.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkType.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

namespace flattening
{
namespace bridge
{
namespace
{
/// Segments joined end to end.
struct SegmentChain
{
  std::vector<vtkIdType> points; ///< the first again at the end where the chain is closed
  std::size_t firstSegment = 0;  ///< the smallest index of its segments
};

/// Joins segments wherever two of them, and no more, meet in a point. A chain runs in the direction
/// of its first segment; chains come in the order of their first segments.
std::vector<SegmentChain> chainSegments(const std::vector<std::array<vtkIdType, 2>>& segments)
{
  std::map<vtkIdType, std::vector<std::size_t>> segmentsAt;
  for (std::size_t s = 0; s < segments.size(); ++s)
  {
    segmentsAt[segments[s][0]].push_back(s);
    segmentsAt[segments[s][1]].push_back(s);
  }
  std::vector<char> used(segments.size(), 0);
  // Goes on from the last point as long as there is one way.
  auto extend = [&](std::vector<vtkIdType>& points) {
    for (;;)
    {
      const vtkIdType end = points.back();
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
    std::vector<vtkIdType> forward{ segments[s][1] };
    std::vector<vtkIdType> backward{ segments[s][0] };
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

/// What the arrays say of a line cell.
struct Attributes
{
  CurveType type = CurveType::Accessory;
  std::string name;
  KeyShape keyShape = KeyShape::Surface;
  double tolerance = 0.0;
  LengthEase ease;

  auto values() const
  {
    return std::tie(this->type, this->name, this->keyShape, this->tolerance, this->ease.fraction,
      this->ease.piece);
  }
  bool operator<(const Attributes& other) const { return this->values() < other.values(); }
};

struct Chain
{
  vtkIdType cell = -1; ///< the first one
  Attributes attributes;
  std::vector<vtkIdType> points;
};

/// Reads the line cells of one data set.
class LineReader
{
public:
  LineReader(vtkPolyData* data, int source, CurveInput& curves)
    : Data(data)
    , Source(source)
    , Curves(curves)
    , Choice(data, GhostCells::LeftOut)
    , FirstLine(data->GetNumberOfVerts())
  {
  }

  bool read()
  {
    return this->checkCells() && this->checkArrays() && this->collectChains() &&
      this->appendPolylines();
  }

private:
  bool refuse(Status status)
  {
    this->Curves.outcome = std::move(status);
    this->Curves.blamed = this->Source;
    return false;
  }

  bool refuseCell(vtkIdType cell, const std::string& what, const char* suggested)
  {
    return this->refuse(refuseCurve(cell, what, suggested));
  }

  static ElementIds ofCell(vtkIdType cell)
  {
    return { ElementKind::Curves, std::vector<std::int64_t>{ cell } };
  }

  bool checkCells()
  {
    return this->Data->GetLines()->IsValid() ||
      this->refuse(
        { StatusCode::InvalidPointId, "the lines of the curves do not fit the list of their points",
          {}, { Remedy::WriteAgain } });
  }

  bool checkArrays()
  {
    vtkCellData* cells = this->Data->GetCellData();
    this->Type = cells->GetAbstractArray("CurveType");
    this->Name = cells->GetAbstractArray("CurveName");
    this->Shape = cells->GetAbstractArray("KeyShape");
    this->Tolerance = cells->GetAbstractArray("LengthTolerance");
    this->Ease = cells->GetAbstractArray("LengthEase");
    this->EasedPiece = cells->GetAbstractArray("EasedPiece");
    this->Planar = this->Data->GetPointData()->GetAbstractArray("PlanarShape");
    for (vtkAbstractArray* array :
      { this->Type, this->Name, this->Shape, this->Tolerance, this->Ease, this->EasedPiece })
    {
      if (!this->hasShape(array, 1, this->Data->GetNumberOfCells(), "cell"))
      {
        return false;
      }
    }
    for (vtkAbstractArray* array :
      { this->Shape, this->Tolerance, this->Ease, this->EasedPiece, this->Planar })
    {
      if (array && !array->IsNumeric())
      {
        return this->refuse({ StatusCode::InvalidCurve,
          std::string("the array ") + array->GetName() + " of the curves holds no numbers", {},
          { { Remedy::Give, "it as numbers" } } });
      }
    }
    return this->hasShape(this->Planar, 2, this->Data->GetNumberOfPoints(), "point");
  }

  bool hasShape(vtkAbstractArray* array, int components, vtkIdType tuples, const char* what)
  {
    if (!array ||
      (array->GetNumberOfComponents() == components && array->GetNumberOfTuples() >= tuples))
    {
      return true;
    }
    return this->refuse({ StatusCode::InvalidCurve,
      std::string("the array ") + array->GetName() + " of the curves has another shape", {},
      { { Remedy::Give,
        "it " + std::to_string(components) + (components == 1 ? " component" : " components") +
          " and a value for each " + what } } });
  }

  bool readType(vtkIdType cell, CurveType& type)
  {
    if (!this->Type)
    {
      return true;
    }
    const vtkVariant value = this->Type->GetVariantValue(cell);
    for (const CurveType candidate :
      { CurveType::Accessory, CurveType::Key, CurveType::Dart, CurveType::Seam })
    {
      const bool equal = value.IsNumeric() ? value.ToDouble() == static_cast<int>(candidate)
                                           : value.ToString() == curveTypeName(candidate);
      if (equal)
      {
        type = candidate;
        return true;
      }
    }
    return this->refuseCell(cell, "has the CurveType \"" + value.ToString() + "\"",
      "0 (accessory), 1 (key), 2 (dart), 3 (seam) or one of these names");
  }

  bool readAttributes(vtkIdType cell, Attributes& attributes)
  {
    if (!this->readType(cell, attributes.type))
    {
      return false;
    }
    if (this->Name)
    {
      attributes.name = withoutNul(this->Name->GetVariantValue(cell).ToString());
    }
    if (this->Shape)
    {
      const double shape = this->Shape->GetVariantValue(cell).ToDouble();
      if (shape != 0.0 && shape != 1.0)
      {
        return this->refuseCell(
          cell, "has an unknown KeyShape", "0 (as on the surface) or 1 (straight)");
      }
      attributes.keyShape = shape == 1.0 ? KeyShape::Straight : KeyShape::Surface;
    }
    if (this->Tolerance)
    {
      attributes.tolerance = this->Tolerance->GetVariantValue(cell).ToDouble();
      Status status = checkTolerance(cell, attributes.tolerance);
      if (!status.ok())
      {
        return this->refuse(std::move(status));
      }
    }
    return this->readEase(cell, attributes.ease);
  }

  bool readEase(vtkIdType cell, LengthEase& ease)
  {
    if (this->Ease)
    {
      ease.fraction = this->Ease->GetVariantValue(cell).ToDouble();
      if (!(std::abs(ease.fraction) < 1.0))
      {
        return this->refuseCell(
          cell, "has a LengthEase outside (-1, 1)", "a fraction of the length");
      }
    }
    if (this->EasedPiece)
    {
      const double piece = this->EasedPiece->GetVariantValue(cell).ToDouble();
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
    if (this->Data->GetNumberOfPoints() > std::numeric_limits<Index>::max())
    {
      return this->refuse({ StatusCode::InvalidOption, "the curves have too many points", {},
        { Remedy::DivideInput } });
    }
    bool sound = true;
    std::map<Attributes, std::vector<Chain>> segments;
    forEachCell(this->Data->GetLines(), [&](vtkIdType k, vtkIdType count, const vtkIdType* ids) {
      const vtkIdType cell = this->FirstLine + k;
      if (!this->Choice.reads(cell))
      {
        return;
      }
      Chain chain;
      chain.cell = cell;
      chain.points.assign(ids, ids + count);
      sound = sound && this->checkPoints(chain) && this->readAttributes(cell, chain.attributes);
      if (sound && count == 2 && ids[0] != ids[1])
      {
        segments[chain.attributes].push_back(std::move(chain));
      }
      else if (sound)
      {
        this->Chains.push_back(std::move(chain));
      }
    });
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
    const vtkIdType count = this->Data->GetNumberOfPoints();
    const bool known = std::all_of(chain.points.begin(), chain.points.end(),
      [count](vtkIdType p) { return p >= 0 && p < count; });
    return known ||
      this->refuse({ StatusCode::InvalidPointId,
        "cell " + std::to_string(chain.cell) + " of the curves uses a point id outside 0.." +
          std::to_string(count - 1),
        ofCell(chain.cell), { Remedy::WriteAgain } });
  }

  void joinSegments(const std::vector<Chain>& segments)
  {
    std::vector<std::array<vtkIdType, 2>> ends;
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
      Polyline polyline;
      polyline.name = chain.attributes.name.empty()
        ? "curve " + std::to_string(this->Curves.polylines.size())
        : chain.attributes.name;
      polyline.type = chain.attributes.type;
      polyline.keyShape = chain.attributes.keyShape;
      polyline.tolerance = chain.attributes.tolerance;
      polyline.ease = chain.attributes.ease;
      for (const vtkIdType p : chain.points)
      {
        Point3 point;
        this->Data->GetPoint(p, point.data());
        polyline.points.push_back(point);
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
    auto* planar = vtkDataArray::SafeDownCast(this->Planar);
    if (!planar)
    {
      return true;
    }
    Points2 shape;
    for (const Index p : polyline.pointIds)
    {
      shape.emplace_back(planar->GetComponent(p, 0), planar->GetComponent(p, 1));
    }
    Status status = takePlanarShape(shape, polyline);
    return status.ok() || this->refuse(std::move(status));
  }

  vtkPolyData* Data;
  int Source;
  CurveInput& Curves;
  CellChoice Choice;
  vtkIdType FirstLine;
  std::vector<Chain> Chains;
  vtkAbstractArray* Type = nullptr;
  vtkAbstractArray* Name = nullptr;
  vtkAbstractArray* Shape = nullptr;
  vtkAbstractArray* Tolerance = nullptr;
  vtkAbstractArray* Ease = nullptr;
  vtkAbstractArray* EasedPiece = nullptr;
  vtkAbstractArray* Planar = nullptr;
};
}

void readCurves(vtkPolyData* data, int source, CurveInput& curves)
{
  if (data->GetNumberOfLines() > 0)
  {
    LineReader(data, source, curves).read();
  }
}
}
}
