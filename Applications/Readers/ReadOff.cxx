// SPDX-License-Identifier: BSD-3-Clause
#include "ReadOff.h"

#include "InputError.h"
#include "TextFile.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <string_view>
#include <vector>

namespace wirewarp
{
namespace
{
/// Lines without comments and empty ones.
struct OffReader
{
  const std::string& path;
  LineReader lines;
  std::string line;

  [[noreturn]] void refuse(const std::string& text) const
  {
    throw InputError(this->path, this->lines.number(), text);
  }

  std::string_view next()
  {
    while (this->lines.next(this->line))
    {
      std::string_view text = std::string_view(this->line).substr(0, this->line.find('#'));
      std::string_view rest = text;
      if (!takeWord(rest).empty())
      {
        return text;
      }
    }
    this->refuse("the file ends before all that its head counts; it is truncated, write it again");
  }

  long long count(std::string_view& rest) const
  {
    const std::string_view word = takeWord(rest);
    long long value = 0;
    if (!parseInteger(word, value) || value < 0)
    {
      this->refuse(inQuotes(word) + " is not a count; write vertices, faces and edges");
    }
    return value;
  }

  void readPoint(vtkPoints* points)
  {
    std::string_view rest = this->next();
    double x[3];
    for (double& coordinate : x)
    {
      const std::string_view word = takeWord(rest);
      if (!parseNumber(word, coordinate))
      {
        this->refuse(inQuotes(word) + " is not a coordinate; write three decimal numbers");
      }
    }
    points->InsertNextPoint(x);
  }

  void readFace(vtkCellArray* polygons, vtkIdType points)
  {
    std::string_view rest = this->next();
    const long long corners = this->count(rest);
    if (corners < 3)
    {
      this->refuse("a face needs three vertices");
    }
    std::vector<vtkIdType> ids;
    for (long long k = 0; k < corners; ++k)
    {
      const std::string_view word = takeWord(rest);
      long long id = 0;
      if (!parseInteger(word, id) || id < 0 || id >= points)
      {
        this->refuse(inQuotes(word) + " is not a vertex id below " + std::to_string(points));
      }
      ids.push_back(id);
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readOff(const std::string& path)
{
  const std::string text = readWholeFile(path);
  OffReader reader{ path, LineReader(text), {} };
  std::string_view head = reader.next();
  const std::string_view kind = takeWord(head);
  if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF")
  {
    reader.refuse(
      inQuotes(kind) + " is not OFF, COFF, NOFF or CNOFF; save the surface so, as text");
  }
  std::string_view rest = head;
  if (takeWord(rest).empty())
  {
    head = reader.next();
  }
  const long long vertices = reader.count(head);
  const long long faces = reader.count(head);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (long long k = 0; k < vertices; ++k)
  {
    reader.readPoint(points);
  }
  for (long long k = 0; k < faces; ++k)
  {
    reader.readFace(polygons, vertices);
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return surface;
}
}
