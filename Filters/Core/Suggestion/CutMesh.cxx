// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutMesh.h"

#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Paths/PlaneSection.h"
#include "Sparse/LinearSolver.h"
#include "Suggestion/ChartClusters.h"
#include "Suggestion/SurfaceMirror.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/SurfacePoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace flattening
{
namespace
{
/// In snap distances of an imprint, how near points of the mirror plane's section are to it.
constexpr double inPlaneShare = 2.0;
/// By what that is more than where the farthest one is.
constexpr double atLeast = 1.0 + 1e-6;
/// How much neighbors keep images from moving apart, one after the other, against a pull of 1 to
/// the surface: as a whole first, then each to where it is alone.
constexpr std::array<double, 8> stiffnesses{ 30.0, 30.0, 10.0, 10.0, 3.0, 3.0, 1.0, 0.5 };
/// The pull of vertices that stay.
constexpr double fixedWeight = 1e6;
/// The least cosine between normals of what faces alike.
constexpr double facing = 0.3;

/// Moves the mirror image of half a surface onto the other half.
class ImageFitting
{
public:
  ImageFitting(const TriangleMesh& half, const TriangleMesh& other, const MirrorSection& mirror)
    : Half(half)
    , Other(other)
    , Mirrored(mirror.plane.mirrored(half.points()))
    , Locator(other)
  {
    for (Index v = 0; v < half.vertexCount(); ++v)
    {
      this->Fixed.push_back(half.onBoundary(v) && mirror.has(half.point(v)) ? 1 : 0);
    }
  }

  Points3 run() const
  {
    Points3 images = this->Mirrored;
    for (double stiffness : stiffnesses)
    {
      this->pull(images, stiffness);
    }
    for (const auto& [v, place] : this->places(images))
    {
      images[v] = place;
    }
    return images;
  }

private:
  /// Of vertices with one the place of the other side that is next to the image and faces alike; on
  /// the boundary of those there.
  std::map<Index, Point3> places(const Points3& images) const
  {
    const Points3 normals = vertexNormals(TriangleMesh(images, this->Half.triangles()));
    std::map<Index, Point3> places;
    for (Index v = 0; v < this->Half.vertexCount(); ++v)
    {
      if (this->Fixed[v] || this->Half.onBoundary(v))
      {
        places[v] =
          this->Fixed[v] ? this->Half.point(v) : nearestOnBoundary(this->Other, images[v]);
        continue;
      }
      const ClosestPoint closest = this->Locator.closest(images[v]);
      // Mirrored triangles are turned over.
      if (-normals[v].dot(triangleNormal(this->Other, closest.triangle)) > facing)
      {
        places[v] = closest.position;
      }
    }
    return places;
  }

  /// Moves images smoothly towards their places.
  void pull(Points3& images, double stiffness) const
  {
    const Index count = this->Half.vertexCount();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 3);
    for (const auto& [v, place] : this->places(images))
    {
      const double weight = this->Fixed[v] ? fixedWeight : 1.0;
      entries.emplace_back(v, v, weight);
      right.row(v) = weight * (place - this->Mirrored[v]).transpose();
    }
    for (Index h = 0; h < this->Half.halfedgeCount(); ++h)
    {
      const Index a = this->Half.from(h);
      const Index b = this->Half.to(h);
      if (this->Half.twin(h) == none || a < b) // each edge once
      {
        entries.emplace_back(a, a, stiffness);
        entries.emplace_back(b, b, stiffness);
        entries.emplace_back(std::max(a, b), std::min(a, b), -stiffness);
      }
    }
    SparseMatrix matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    LinearSolver solver;
    solver.factorize(matrix);
    const Eigen::MatrixXd moves = solver.solve(right);
    for (Index v = 0; v < count && moves.rows() == count; ++v)
    {
      images[v] = this->Mirrored[v] + Point3(moves.row(v));
    }
  }

  const TriangleMesh& Half;
  const TriangleMesh& Other;
  Points3 Mirrored;
  SurfaceLocator Locator;  ///< of the other half
  std::vector<char> Fixed; ///< in the plane
};
}

CutMesh cutAlong(const ImprintedSurface& imprinted)
{
  CutMesh result;
  result.mesh = imprinted.mesh;
  result.cut.assign(result.mesh.halfedgeCount(), 0);
  for (const FeatureCurve& curve : imprinted.curves)
  {
    forEachEdge(curve.vertices, [&](Index a, Index b) {
      const Index h = result.mesh.find(a, b);
      const Index twin = h == none ? none : result.mesh.twin(h);
      if (twin != none)
      {
        result.cut[h] = result.cut[twin] = 1;
      }
    });
  }
  return result;
}

MirrorSection sectionOf(const TriangleMesh& surface, const SymmetryPlane& plane)
{
  return { plane, inPlaneShare * SnapDistance(surface, ImprintOptions().snap).greatest() };
}

TriangleMesh halfOf(TriangleMesh& surface, MirrorSection& mirror)
{
  std::vector<Polyline> seams;
  for (const PlaneSection& section :
    planeSections(surface, mirror.plane.offset * mirror.plane.normal, mirror.plane.normal))
  {
    Polyline seam;
    seam.type = CurveType::Seam;
    seam.points = positionsOf(section.path.points);
    seams.push_back(std::move(seam));
  }
  ImprintedSurface imprinted = imprintCurves(surface, seams, {});
  if (seams.empty() || !imprinted.status.ok())
  {
    return {};
  }
  const CutSurface cut = cutSurface(imprinted.mesh, imprinted.curves);
  for (const FeatureCurve& curve : imprinted.curves)
  {
    for (Index v : curve.vertices) // of the surface, where these are near
    {
      mirror.distance =
        std::max(mirror.distance, atLeast * std::abs(mirror.plane.side(imprinted.mesh.point(v))));
    }
  }
  surface = std::move(imprinted.mesh);
  std::vector<double> side(cut.pieceCount, 0.0);
  std::vector<char> open(cut.mesh.halfedgeCount(), 0);
  for (Index h = 0; h < cut.mesh.halfedgeCount(); ++h)
  {
    open[h] = cut.mesh.twin(h) == none ? 1 : 0;
    side[cut.pieceOfTriangle[h / 3]] +=
      cut.mesh.area(h / 3) * mirror.plane.side(cut.mesh.point(cut.mesh.from(h)));
  }
  Indices triangles;
  for (Index t = 0; t < cut.mesh.triangleCount(); ++t)
  {
    if (side[cut.pieceOfTriangle[t]] > 0.0)
    {
      triangles.push_back(t);
    }
  }
  return openedPart(surface, triangles, open).mesh;
}

CutMesh withoutBridges(CutMesh half, const std::optional<MirrorSection>& mirror)
{
  if (!mirror)
  {
    return half;
  }
  Points3 points = half.mesh.points();
  Triangles cells = half.mesh.triangles();
  std::set<std::pair<Index, Index>> cut;
  const auto ends = [](Index a, Index b) { return std::pair(std::min(a, b), std::max(a, b)); };
  const auto inPlane = [&](Index v) {
    return half.mesh.onBoundary(v) && mirror->has(half.mesh.point(v));
  };
  for (Index h = 0; h < half.mesh.halfedgeCount(); ++h)
  {
    const Index a = half.mesh.from(h);
    const Index b = half.mesh.to(h);
    if (half.cut[h])
    {
      cut.insert(ends(a, b));
    }
    if (half.mesh.twin(h) < h || !inPlane(a) || !inPlane(b))
    {
      continue;
    }
    const auto middle = static_cast<Index>(points.size());
    points.emplace_back(0.5 * (points[a] + points[b]));
    for (std::size_t t = 0, count = cells.size(); t < count; ++t)
    {
      Triangle& cell = cells[t];
      const auto first = std::find(cell.begin(), cell.end(), a);
      const auto second = std::find(cell.begin(), cell.end(), b);
      if (first != cell.end() && second != cell.end())
      {
        Triangle other = cell;
        *first = middle;
        std::replace(other.begin(), other.end(), b, middle);
        cells.push_back(other);
      }
    }
    if (half.cut[h])
    {
      cut.insert({ ends(a, middle), ends(b, middle) });
    }
  }
  half.mesh = TriangleMesh(std::move(points), std::move(cells));
  half.cut.assign(half.mesh.halfedgeCount(), 0);
  for (Index h = 0; h < half.mesh.halfedgeCount(); ++h)
  {
    half.cut[h] = cut.count(ends(half.mesh.from(h), half.mesh.to(h))) > 0 ? 1 : 0;
  }
  return half;
}

Points3 imagesOfHalf(
  const TriangleMesh& half, const TriangleMesh& surface, const MirrorSection& mirror)
{
  Indices otherSide;
  for (Index t = 0; t < surface.triangleCount(); ++t)
  {
    if (mirror.plane.side(surface.centroid(t)) < 0.0)
    {
      otherSide.push_back(t);
    }
  }
  if (mirror.plane.error <= SurfaceMirror::exact || otherSide.empty())
  {
    return mirror.plane.mirrored(half.points());
  }
  const TriangleMesh other =
    openedPart(surface, otherSide, std::vector<char>(surface.halfedgeCount(), 0)).mesh;
  return ImageFitting(half, other, mirror).run();
}

CutMesh bothSides(
  const CutMesh& half, const std::optional<MirrorSection>& mirror, const Points3& images)
{
  CutMesh whole = half;
  const Index count = half.mesh.halfedgeCount();
  whole.images.resize(count);
  std::iota(whole.images.begin(), whole.images.end(), 0);
  if (!mirror)
  {
    return whole;
  }
  Points3 points = half.mesh.points();
  Indices image;
  for (Index v = 0; v < half.mesh.vertexCount(); ++v)
  {
    const bool shared = half.mesh.onBoundary(v) && mirror->has(points[v]);
    image.push_back(shared ? v : static_cast<Index>(points.size()));
    if (!shared)
    {
      points.push_back(images.empty() ? mirror->plane.mirrored(points[v]) : images[v]);
    }
  }
  Triangles cells = half.mesh.triangles();
  for (const auto& [a, b, c] : half.mesh.triangles())
  {
    cells.push_back({ image[a], image[c], image[b] });
  }
  whole.mesh = TriangleMesh(std::move(points), std::move(cells));
  whole.cut.resize(2 * count);
  whole.images.resize(2 * count);
  for (Index h = 0; h < count; ++h)
  {
    const Index other = count + h / 3 * 3 + 2 - h % 3;
    whole.cut[h] = whole.cut[other] = half.cut[h] || whole.mesh.twin(h) == other ? 1 : 0;
    whole.images[h] = other;
    whole.images[other] = h;
  }
  return whole;
}
}
