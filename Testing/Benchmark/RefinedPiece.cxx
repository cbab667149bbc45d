// SPDX-License-Identifier: BSD-3-Clause
#include "RefinedPiece.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <map>
#include <stdexcept>
#include <utility>

namespace benchmarks
{
namespace
{
using namespace flattening;

vtkSmartPointer<vtkPolyData> read(const std::string& path)
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

/// Calls a function with the points of each cell and its number.
template <class Visit>
void forCells(vtkCellArray* cells, const Visit& visit)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    visit(Indices(ids->begin(), ids->end()), cell);
  }
}

Points3 pointsOf(vtkPolyData* data)
{
  Points3 points;
  for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k)
  {
    points.emplace_back(data->GetPoint(k));
  }
  return points;
}

/// Divides triangles; vertices on edges are shared.
class Refinement
{
public:
  Refinement(const TriangleMesh& mesh, int division)
    : Mesh(mesh)
    , Division(division)
    , Points(mesh.points())
    , Normals(mesh.points().size(), Point3::Zero())
  {
    for (const Triangle& c : mesh.triangles())
    {
      const Point3 normal =
        (mesh.point(c[1]) - mesh.point(c[0])).cross(mesh.point(c[2]) - mesh.point(c[0]));
      for (Index v : c)
      {
        this->Normals[v] += normal;
      }
    }
    for (Point3& normal : this->Normals)
    {
      normal.normalize();
    }
    for (Index t = 0; t < mesh.triangleCount(); ++t)
    {
      this->divide(mesh.triangle(t));
    }
  }

  RefinedPiece piece(const std::vector<FeatureCurve>& coarse)
  {
    std::vector<FeatureCurve> curves = coarse;
    for (FeatureCurve& curve : curves)
    {
      const Indices corners = std::move(curve.vertices);
      curve.vertices = { corners.front() };
      for (std::size_t k = 1; k < corners.size(); ++k)
      {
        for (int step = 1; step < this->Division; ++step)
        {
          curve.vertices.push_back(this->onEdge(corners[k - 1], corners[k], step));
        }
        curve.vertices.push_back(corners[k]);
      }
    }
    return { TriangleMesh(std::move(this->Points), std::move(this->Fine)), std::move(curves) };
  }

private:
  /// Control point of the cubic at a third of the way from a to b.
  Point3 control(Index a, Index b) const
  {
    const Point3& from = this->Mesh.point(a);
    const Point3& to = this->Mesh.point(b);
    return (2.0 * from + to - (to - from).dot(this->Normals[a]) * this->Normals[a]) / 3.0;
  }

  Point3 onCubic(Index a, Index b, double s) const
  {
    const double r = 1.0 - s;
    return r * r * r * this->Mesh.point(a) + 3.0 * r * r * s * this->control(a, b) +
      3.0 * r * s * s * this->control(b, a) + s * s * s * this->Mesh.point(b);
  }

  Index onEdge(Index a, Index b, int step)
  {
    Indices& between = this->Edges[std::minmax(a, b)];
    if (between.empty())
    {
      for (int k = 1; k < this->Division; ++k)
      {
        between.push_back(static_cast<Index>(this->Points.size()));
        this->Points.push_back(
          this->onCubic(std::min(a, b), std::max(a, b), static_cast<double>(k) / this->Division));
      }
    }
    return between[a < b ? step - 1 : this->Division - step - 1];
  }

  Point3 inside(const Triangle& c, double u, double v, double w) const
  {
    const Point3 edges =
      (this->control(c[0], c[1]) + this->control(c[1], c[0]) + this->control(c[1], c[2]) +
        this->control(c[2], c[1]) + this->control(c[2], c[0]) + this->control(c[0], c[2])) /
      6.0;
    const Point3 corners =
      (this->Mesh.point(c[0]) + this->Mesh.point(c[1]) + this->Mesh.point(c[2])) / 3.0;
    const Point3 middle = 1.5 * edges - 0.5 * corners;
    const std::array<double, 3> weight{ u, v, w };
    Point3 point = 6.0 * u * v * w * middle;
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      point += weight[k] * weight[k] * weight[k] * this->Mesh.point(c[k]);
      point += 3.0 * weight[k] * weight[k] * weight[next] * this->control(c[k], c[next]);
      point += 3.0 * weight[k] * weight[next] * weight[next] * this->control(c[next], c[k]);
    }
    return point;
  }

  void divide(const Triangle& c)
  {
    // Row i runs from edge c0-c2 to edge c0-c1's opposite side; (i, j) weighs c1 by j, c2 by i - j.
    const int n = this->Division;
    std::vector<Indices> rows(n + 1);
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        rows[i].push_back(this->vertex(c, n - i, j, i - j));
      }
    }
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        this->Fine.push_back({ rows[i][j], rows[i + 1][j + 1], rows[i + 1][j] });
        if (j < i)
        {
          this->Fine.push_back({ rows[i][j], rows[i][j + 1], rows[i + 1][j + 1] });
        }
      }
    }
  }

  Index vertex(const Triangle& c, int a, int b, int d)
  {
    const int n = this->Division;
    if (a == n || b == n || d == n)
    {
      return c[a == n ? 0 : b == n ? 1 : 2];
    }
    if (d == 0)
    {
      return this->onEdge(c[0], c[1], b);
    }
    if (a == 0)
    {
      return this->onEdge(c[1], c[2], d);
    }
    if (b == 0)
    {
      return this->onEdge(c[2], c[0], a);
    }
    this->Points.push_back(this->inside(c, double(a) / n, double(b) / n, double(d) / n));
    return static_cast<Index>(this->Points.size()) - 1;
  }

  const TriangleMesh& Mesh;
  int Division;
  Points3 Points;
  Points3 Normals;
  Triangles Fine;
  std::map<std::pair<Index, Index>, Indices> Edges;
};
}

DataPiece readPiece(const std::string& surfaceFile, const std::string& curvesFile)
{
  DataPiece piece;
  const auto surface = read(surfaceFile);
  piece.points = pointsOf(surface);
  forCells(surface->GetPolys(), [&](const Indices& ids, vtkIdType) {
    piece.triangles.push_back({ ids.at(0), ids.at(1), ids.at(2) });
  });
  const auto curves = read(curvesFile);
  const Points3 points = pointsOf(curves);
  vtkDataArray* const types = curves->GetCellData()->GetArray("CurveType");
  forCells(curves->GetLines(), [&](const Indices& ids, vtkIdType cell) {
    Polyline& curve = piece.curves.emplace_back();
    curve.name = "c" + std::to_string(cell);
    curve.type = types ? static_cast<CurveType>(types->GetTuple1(cell)) : CurveType::Accessory;
    curve.pointIds = ids;
    for (const Index id : ids)
    {
      curve.points.push_back(points[id]);
    }
  });
  return piece;
}

RefinedPiece readRefined(const std::string& folder, const std::string& name, int division)
{
  const std::string path = folder + "/" + name;
  DataPiece piece = readPiece(path + ".vtp", path + "_curves.vtp");
  const TriangleMesh coarse(std::move(piece.points), std::move(piece.triangles));
  const ImprintedSurface imprinted = imprintCurves(coarse, piece.curves, {}, {});
  if (!imprinted.status.ok() || imprinted.mesh.triangleCount() != coarse.triangleCount())
  {
    throw std::runtime_error("the curves do not run along edges. " + imprinted.status.message);
  }
  return Refinement(coarse, division).piece(imprinted.curves);
}
}
