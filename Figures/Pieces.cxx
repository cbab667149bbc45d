// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces.h"

#include "Files.h"

#include <vtkLeastSquaresConformalFilter.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSurfaceDevelopability.h>
#include <vtkVariant.h>
#include <vtkWireWarpingFilter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtksys/Directory.hxx>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace figures
{
namespace
{
PolyData read(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw std::runtime_error("cannot read " + path);
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

FlatPiece run(vtkFlatPieceAlgorithm* filter, const Piece& piece)
{
  // The outputs tell of broken promises too, and a refusal is thrown.
  silence(filter);
  filter->SetInputData(piece.surface);
  filter->SetCurvesData(piece.curves);
  filter->Update();
  if (filter->IsRefused())
  {
    throw std::runtime_error(filter->GetStatusMessage());
  }
  return outputsOf(filter);
}

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
}

Piece readPiece(const std::string& folder, const std::string& name, const std::string& set)
{
  const std::string path = folder + "/" + name;
  return { read(path + ".vtp"), read(path + "_curves" + set + ".vtp") };
}

std::vector<std::string> listPieces(const std::string& folder)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> names;
  for (unsigned long k = 0; k < directory.GetNumberOfFiles(); ++k)
  {
    const std::string file = directory.GetFile(k);
    if (endsWith(file, ".vtp") && file.find("_curves") == std::string::npos)
    {
      names.push_back(file.substr(0, file.size() - 4));
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

FlatPiece outputsOf(vtkFlatPieceAlgorithm* filter)
{
  const double* const seconds = filter->GetSeconds();
  return { filter->GetOutput(0), filter->GetOutput(1), filter->GetOutput(2), filter->GetPieces(),
    filter->GetCurves(), { seconds[0], seconds[1], seconds[2], seconds[3] } };
}

PolyData FlatPiece::wiresOn(const PolyData& surface) const
{
  PolyData result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(this->wires);
  result->SetPoints(surface->GetPoints()); // ids are those of the flat piece
  return result;
}

double FlatPiece::number(const char* column, vtkIdType row) const
{
  const bool known =
    this->pieces && this->pieces->GetColumnByName(column) && row < this->pieces->GetNumberOfRows();
  return known ? this->pieces->GetValueByName(row, column).ToDouble() : std::nan("");
}

FlatPiece flatten(const Piece& piece, Method method, Interior interior)
{
  if (method == Method::LeastSquaresConformal)
  {
    vtkNew<vtkLeastSquaresConformalFilter> filter;
    return run(filter, piece);
  }
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetScheme(method == Method::Progressive ? vtkWireWarpingFilter::PROGRESSIVE
      : method == Method::Global                  ? vtkWireWarpingFilter::GLOBAL
                                                  : vtkWireWarpingFilter::ISOMETRIC);
  filter->SetDartLegsToFree(); // as in the paper
  filter->SetInterior(interior == Interior::Paper ? vtkWireWarpingFilter::LAPLACIAN
                                                  : vtkWireWarpingFilter::AS_RIGID_AS_POSSIBLE);
  return run(filter, piece);
}

PolyData measureDevelopability(const PolyData& surface)
{
  vtkNew<vtkSurfaceDevelopability> filter;
  silence(filter);
  filter->SetInputData(surface);
  filter->Update();
  if (filter->IsRefused())
  {
    throw std::runtime_error(filter->GetStatusMessage());
  }
  return filter->GetOutput();
}

PolyData moved(const PolyData& data, double x, double y, double z)
{
  PolyData result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(data);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k)
  {
    double point[3];
    data->GetPoint(k, point);
    points->SetPoint(k, point[0] + x, point[1] + y, point[2] + z);
  }
  result->SetPoints(points);
  return result;
}

void layBeside(std::vector<FlatPiece>& pieces)
{
  double extent = 0.0;
  for (const FlatPiece& piece : pieces)
  {
    extent = std::max(extent, piece.flat->GetLength());
  }
  double x = 0.0;
  for (FlatPiece& piece : pieces)
  {
    const double* const bounds = piece.flat->GetBounds();
    const double dx = x - bounds[0];
    const double dy = -bounds[2];
    x += bounds[1] - bounds[0] + 0.08 * extent;
    piece.flat = moved(piece.flat, dx, dy);
    piece.wires = moved(piece.wires, dx, dy);
  }
}
}
