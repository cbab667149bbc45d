// SPDX-License-Identifier: BSD-3-Clause
#include "ReadDxfCurves.h"

#include "DxfShapes.h"
#include "InputError.h"
#include "TextFile.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkType.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

namespace wirewarp
{
namespace
{
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
    , lines(text, false)
  {
  }

  const std::string& path;
  LineReader lines;

  vtkNew<vtkPoints> points;
  std::map<DxfPlace, vtkIdType> pointAt;
  CurveList curves;
  DxfEntity entity;
  DxfEntity polyline; ///< whose vertices are on their way
  bool inPolyline = false;
  bool inEntities = false;
  std::map<std::string, std::vector<std::string>> unread; ///< places of entities, by their kinds

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  double number(const std::string& value) const
  {
    double result = 0.0;
    if (!parseNumber(wordOf(value), result) || !std::isfinite(result))
    {
      this->refuse(inQuotes(value) + " is not a number; save the DXF file as text again");
    }
    return result;
  }

  void addCurve(const DxfEntity& source)
  {
    const DxfCourse course = courseOf(source);
    if (!course.fault.empty())
    {
      throw InputError(this->path, source.line, "the " + source.kind + " " + course.fault);
    }
    if (course.places.size() < 2)
    {
      return;
    }
    std::vector<vtkIdType> ids;
    for (const DxfPlace& place : course.places)
    {
      const auto [known, added] =
        this->pointAt.emplace(place, this->points->GetNumberOfPoints()); // so that lines join
      if (added)
      {
        this->points->InsertNextPoint(place.data());
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
      const std::vector<DxfPlace> places = this->entity.places(10);
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
    else if (this->entity.kind == "POLYLINE" && isDxfCurve(this->entity))
    {
      this->inPolyline = true;
      this->polyline = this->entity;
    }
    else if (isDxfCurve(this->entity))
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
        this->refuse(
          inQuotes(code) + " is no group code; the file may be binary DXF or be damaged");
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

//------------------------------------------------------------------------------
CurveContents readDxfCurves(const std::string& path)
{
  const std::string text = readWholeFile(path);
  DxfReader reader(path, text);
  reader.points->SetDataTypeToDouble();
  reader.read();
  const std::string unread = reader.listUnread();
  if (reader.curves.empty())
  {
    throw InputError(path,
      std::string("has no ") + curveEntities + " among its entities" +
        (unread.empty() ? "" : ", but " + unread) + "; draw the feature curves so");
  }
  return { reader.curves.polyData(reader.points),
    unread.empty()
      ? ""
      : "not read: " + unread + "; explode blocks, and draw feature curves as " + curveEntities };
}
}
