// SPDX-License-Identifier: BSD-3-Clause
#include "ReadDxfCurves.h"

#include "CurveList.h"
#include "InputError.h"
#include "TextFile.h"

#include <vtkPoints.h>

#include <array>
#include <map>

namespace wirewarp
{
namespace
{
using Place = std::array<double, 3>;

/// An entity, or a VERTEX of one. Group codes: AutoCAD's "DXF Reference", the section ENTITIES.
struct Entity
{
  std::string kind;
  std::string layer = "0";
  std::vector<Place> places; ///< from codes 10, 20, 30 and of a LINE also 11, 21, 31
  double elevation = 0.0;    ///< of an LWPOLYLINE, code 38
  long long flags = 0;       ///< code 70: 1 is closed, 64 and 128 are vertices of no polyline
};

struct DxfReader
{
  DxfReader(const std::string& file, const std::string& text)
    : path(file)
    , lines(text)
  {
  }

  const std::string& path;
  LineReader lines;

  vtkNew<vtkPoints> points;
  std::map<Place, vtkIdType> pointAt;
  CurveList curves;
  Entity entity;
  Entity polyline; ///< whose vertices are on their way
  bool inPolyline = false;
  bool inEntities = false;

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  double number(const std::string& value) const
  {
    std::string_view rest(value);
    const std::string_view word = takeWord(rest);
    double result = 0.0;
    if (!parseNumber(word, result))
    {
      this->refuse(inQuotes(value) + " is not a coordinate; save the DXF file as text again");
    }
    return result;
  }

  void addCurve(const Entity& source)
  {
    if (source.places.size() < 2)
    {
      return;
    }
    std::vector<vtkIdType> ids;
    for (const Place& place : source.places)
    {
      const auto [known, added] =
        this->pointAt.emplace(place, this->points->GetNumberOfPoints()); // so that lines join
      if (added)
      {
        this->points->InsertNextPoint(place.data());
      }
      ids.push_back(known->second);
    }
    if (source.kind != "LINE" && (source.flags & 1) != 0)
    {
      ids.push_back(ids.front());
    }
    this->curves.add(ids, curveTitle(source.layer));
  }

  /// What the next entity's beginning ends.
  void endEntity()
  {
    if (this->entity.kind == "LINE" || this->entity.kind == "LWPOLYLINE")
    {
      for (Place& place : this->entity.places)
      {
        place[2] += this->entity.elevation;
      }
      this->addCurve(this->entity);
    }
    else if (this->entity.kind == "POLYLINE")
    {
      // 16 and 64: meshes of polygons. Its own place is that of no vertex.
      this->inPolyline = (this->entity.flags & (16 | 64)) == 0;
      this->polyline = this->entity;
      this->polyline.places.clear();
    }
    else if (this->entity.kind == "VERTEX" && this->inPolyline && !this->entity.places.empty())
    {
      // 16: a point of the frame of a spline, beside the points on the spline.
      if ((this->entity.flags & 16) == 0)
      {
        this->polyline.places.push_back(this->entity.places.front());
      }
    }
    else if (this->entity.kind == "SEQEND" && this->inPolyline)
    {
      this->addCurve(this->polyline);
      this->inPolyline = false;
    }
    this->entity = {};
  }

  void readGroup(long long code, const std::string& value)
  {
    std::vector<Place>& places = this->entity.places;
    if (code == 8)
    {
      this->entity.layer = value;
    }
    else if (code == 10 || code == 11)
    {
      places.push_back({ this->number(value), 0.0, 0.0 });
    }
    else if ((code == 20 || code == 21 || code == 30 || code == 31) && !places.empty())
    {
      places.back()[code / 10 - 1] = this->number(value);
    }
    else if (code == 38)
    {
      this->entity.elevation = this->number(value);
    }
    else if (code == 70)
    {
      std::string_view rest(value);
      parseInteger(takeWord(rest), this->entity.flags);
    }
  }

  void read()
  {
    std::string code;
    std::string value;
    while (this->lines.next(code) && this->lines.next(value))
    {
      std::string_view rest(code);
      long long group = 0;
      if (!parseInteger(takeWord(rest), group))
      {
        this->refuse(
          inQuotes(code) + " is no group code; the file may be binary DXF or be damaged");
      }
      if (group == 0)
      {
        this->endEntity();
        std::string_view word(value);
        this->entity.kind = takeWord(word);
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
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readDxfCurves(const std::string& path)
{
  const std::string text = readWholeFile(path);
  DxfReader reader(path, text);
  reader.points->SetDataTypeToDouble();
  reader.read();
  if (reader.curves.empty())
  {
    throw InputError(
      path, "has no LINE, LWPOLYLINE or POLYLINE among its entities; draw the feature curves so");
  }
  return reader.curves.polyData(reader.points);
}
}
