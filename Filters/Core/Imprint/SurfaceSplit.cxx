// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/SurfaceSplit.h"

#include "Imprint/ConstrainedDelaunay.h"
#include "Imprint/ImprintedSurface.h"
#include "Surface/SurfacePoint.h"
#include "Surface/SurfacePreparation.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace flattening
{
namespace
{
/// Height over longest edge above what prepareSurface() takes for a triangle without area, by more
/// than the rounding of either.
constexpr double surelyHigh = 1.01 * flatTriangle;

struct NodeOnEdge
{
  double fraction; ///< from the start of the half-edge
  Index node;
};

bool before(const NodeOnEdge& node, double fraction)
{
  return node.fraction < fraction;
}

/// The vertices of a mesh that is split: those of the mesh before, with their ids, and the nodes
/// after them, which lie on its edges and inside its triangles.
class SplitNodes
{
public:
  struct Place
  {
    Index node;
    bool isNew;
  };

  /// Mesh and distance stay the caller's and must outlive the nodes.
  SplitNodes(const TriangleMesh& mesh, const SnapDistance& snap)
    : Mesh(mesh)
    , Snap(snap)
    , VertexCount(mesh.vertexCount())
  {
  }

  /// The node of a point of the surface: the one already there, or one within the snap distance on
  /// the same edge, or a new one.
  Place place(const SurfacePoint& point)
  {
    if (point.type == SurfacePointType::Vertex)
    {
      return { point.id, false };
    }
    const auto [known, isUnknown] =
      this->Known.emplace(std::make_tuple(point.type, point.id, point.weights), none);
    Index& node = known->second;
    if (!isUnknown)
    {
      return { node, false };
    }
    if (point.type == SurfacePointType::Face)
    {
      node = this->add(point);
      return { node, true };
    }
    std::vector<NodeOnEdge>& nodes = this->OnEdge[point.id];
    const double fraction = point.weights[1];
    node = nearest(nodes, fraction, this->Snap.ofEdge(point.id) / this->Mesh.length(point.id));
    if (node != none)
    {
      return { node, false };
    }
    node = this->add(point);
    const auto after = std::lower_bound(nodes.begin(), nodes.end(), fraction, before);
    nodes.insert(after, { fraction, node });
    return { node, true };
  }

  /// A node inside a triangle where there is none yet.
  Index add(const SurfacePoint& point)
  {
    this->Nodes.push_back(point);
    this->Alias.push_back(none);
    return this->VertexCount + static_cast<Index>(this->Nodes.size()) - 1;
  }

  /// Makes one node of two; `into` stays.
  void merge(Index node, Index into) { this->Alias[node - this->VertexCount] = into; }

  SurfacePoint point(Index node) const
  {
    return node < this->VertexCount ? vertexPoint(this->Mesh, node)
                                    : this->Nodes[node - this->VertexCount];
  }

  /// The nodes of an edge in the direction of a half-edge.
  std::vector<NodeOnEdge> along(Index halfedge) const
  {
    const Index edge = edgeOf(this->Mesh, halfedge);
    const auto found = this->OnEdge.find(edge);
    if (found == this->OnEdge.end())
    {
      return {};
    }
    std::vector<NodeOnEdge> nodes = found->second;
    if (edge != halfedge)
    {
      std::reverse(nodes.begin(), nodes.end());
      for (NodeOnEdge& node : nodes)
      {
        node.fraction = 1.0 - node.fraction;
      }
    }
    return nodes;
  }

  /// Numbers what is left of the nodes, once all are there.
  std::vector<VertexSource> numberVertices()
  {
    std::vector<VertexSource> sources(this->VertexCount);
    for (Index v = 0; v < this->VertexCount; ++v)
    {
      sources[v].vertices = { v, v, v };
    }
    this->VertexOfNode.assign(this->Nodes.size(), none);
    for (std::size_t i = 0; i < this->Nodes.size(); ++i)
    {
      if (this->Alias[i] != none)
      {
        continue;
      }
      const SurfacePoint& point = this->Nodes[i];
      const bool onEdge = point.type == SurfacePointType::Edge;
      const Index from = onEdge ? this->Mesh.from(point.id) : none;
      this->VertexOfNode[i] = static_cast<Index>(sources.size());
      sources.push_back(
        { onEdge ? Triangle{ from, this->Mesh.to(point.id), from } : this->Mesh.triangle(point.id),
          point.weights });
    }
    return sources;
  }

  /// \pre numberVertices() was called.
  Index vertex(Index node) const
  {
    while (node >= this->VertexCount && this->Alias[node - this->VertexCount] != none)
    {
      node = this->Alias[node - this->VertexCount];
    }
    return node < this->VertexCount ? node : this->VertexOfNode[node - this->VertexCount];
  }

private:
  /// The node next to a place on an edge, none within the distance (a fraction of the edge).
  static Index nearest(const std::vector<NodeOnEdge>& nodes, double fraction, double distance)
  {
    const auto after = std::lower_bound(nodes.begin(), nodes.end(), fraction, before);
    Index node = none;
    double least = distance;
    if (after != nodes.begin() && fraction - (after - 1)->fraction <= least)
    {
      node = (after - 1)->node;
      least = fraction - (after - 1)->fraction;
    }
    return after != nodes.end() && after->fraction - fraction <= least ? after->node : node;
  }

  const TriangleMesh& Mesh;
  const SnapDistance& Snap;
  Index VertexCount;
  std::vector<SurfacePoint> Nodes; ///< those after the vertices
  Indices Alias;                   ///< the node that a node became one with
  Indices VertexOfNode;
  std::unordered_map<Index, std::vector<NodeOnEdge>> OnEdge; ///< by edgeOf(), in order along each
  std::map<std::tuple<SurfacePointType, Index, std::array<double, 3>>, Index> Known;
};

/// What crosses one triangle of the mesh before.
struct FaceTask
{
  Index triangle = none;
  Indices points; ///< nodes inside
  std::vector<std::array<Index, 2>> segments;
  Indices nodeOfVertex; ///< per vertex of the triangulation
  std::unordered_map<Index, Index> vertexOfNode;
  std::optional<ConstrainedDelaunay> triangulation;
};

/// One stretch of a path: along an edge of the mesh before, or through one of its triangles.
struct Stretch
{
  Index from;
  Index to;
  Index edge = none;
  Index task = none;
};

class Splitter
{
public:
  Splitter(const TriangleMesh& mesh, const SnapDistance& snap)
    : Mesh(mesh)
    , Snap(snap)
    , Nodes(mesh, snap)
  {
  }

  void addPath(const SurfacePath& path)
  {
    std::vector<Stretch> stretches;
    Index last = this->nodeOf(path.points[0]);
    this->Starts.push_back(last);
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
    {
      const Index node = this->nodeOf(path.points[i + 1]);
      Stretch stretch{ last, node };
      stretch.edge = commonEdge(this->Mesh, this->Nodes.point(last), this->Nodes.point(node));
      last = node;
      if (stretch.from == stretch.to)
      {
        continue;
      }
      if (stretch.edge == none)
      {
        stretch.task = this->taskOf(path.triangles[i]);
        this->Tasks[stretch.task].segments.push_back({ stretch.from, stretch.to });
      }
      stretches.push_back(stretch);
    }
    this->Paths.push_back(std::move(stretches));
  }

  SplitSurface run()
  {
    SplitSurface result;
    for (FaceTask& task : this->Tasks)
    {
      if (!this->triangulate(task))
      {
        result.failed.push_back(task.triangle);
      }
    }
    result.surface.vertexSource = this->Nodes.numberVertices();
    this->collectTriangles(result);
    if (result.failed.empty())
    {
      this->collectChains(result);
      Points3 points = this->Mesh.points();
      for (std::size_t v = points.size(); v < result.surface.vertexSource.size(); ++v)
      {
        points.push_back(this->position(result.surface.vertexSource[v]));
      }
      result.surface.mesh = TriangleMesh(std::move(points), std::move(this->Cells));
    }
    return result;
  }

private:
  Index taskOf(Index triangle)
  {
    const auto [place, isNew] =
      this->TaskOfTriangle.emplace(triangle, static_cast<Index>(this->Tasks.size()));
    if (isNew)
    {
      this->Tasks.emplace_back();
      this->Tasks.back().triangle = triangle;
    }
    return place->second;
  }

  Index nodeOf(const SurfacePoint& point)
  {
    const SplitNodes::Place place = this->Nodes.place(point);
    if (place.isNew && point.type == SurfacePointType::Face)
    {
      this->Tasks[this->taskOf(point.id)].points.push_back(place.node);
    }
    else if (place.isNew)
    {
      for (Index t : trianglesAround(this->Mesh, point))
      {
        this->taskOf(t);
      }
    }
    return place.node;
  }

  bool triangulate(FaceTask& task)
  {
    const Index t = task.triangle;
    const Triangle& corners = this->Mesh.triangle(t);
    ConstrainedDelaunay triangulation(this->Mesh.point(corners[0]), this->Mesh.point(corners[1]),
      this->Mesh.point(corners[2]), this->Snap.ofFace(t));
    std::unordered_map<Index, Index>& local = task.vertexOfNode;
    for (int k = 0; k < 3; ++k)
    {
      local[corners[k]] = k;
      task.nodeOfVertex.push_back(corners[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      for (const NodeOnEdge& node : this->Nodes.along(3 * t + k))
      {
        local[node.node] = triangulation.addSidePoint(k, node.fraction);
        task.nodeOfVertex.push_back(node.node);
      }
    }
    triangulation.refine();
    for (Index id : task.points)
    {
      const Index vertex = triangulation.addPoint(this->Nodes.point(id).weights);
      local[id] = vertex;
      if (vertex < static_cast<Index>(task.nodeOfVertex.size()))
      {
        this->Nodes.merge(id, task.nodeOfVertex[vertex]);
      }
      else
      {
        task.nodeOfVertex.push_back(id);
      }
    }
    bool ok = true;
    for (std::array<Index, 2>& segment : task.segments)
    {
      segment = { local[segment[0]], local[segment[1]] };
      ok = ok && triangulation.addSegment(segment[0], segment[1]);
    }
    triangulation.refine();
    for (Index v = static_cast<Index>(task.nodeOfVertex.size()); v < triangulation.vertexCount();
         ++v)
    {
      task.nodeOfVertex.push_back(
        this->Nodes.add({ SurfacePointType::Face, t, triangulation.weights(v), Point3::Zero() }));
    }
    task.triangulation.emplace(std::move(triangulation));
    return ok;
  }

  Point3 position(const VertexSource& source) const
  {
    Point3 sum = Point3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += source.weights[k] * this->Mesh.point(source.vertices[k]);
    }
    return sum;
  }

  void collectTriangles(SplitSurface& result)
  {
    this->Cells = this->Mesh.triangles();
    result.surface.originalTriangle.resize(this->Cells.size());
    std::iota(result.surface.originalTriangle.begin(), result.surface.originalTriangle.end(), 0);
    for (const FaceTask& task : this->Tasks)
    {
      const Point3 normal = triangleNormal(this->Mesh, task.triangle);
      bool good = true;
      const Triangles& cells = task.triangulation->triangles();
      for (const Triangle& cell : cells)
      {
        Triangle corners;
        std::array<Point3, 3> p;
        for (int k = 0; k < 3; ++k)
        {
          corners[k] = this->Nodes.vertex(task.nodeOfVertex[cell[k]]);
          p[k] = this->position(result.surface.vertexSource[corners[k]]);
        }
        good = good && hasArea(p, normal);
        if (&cell == &cells.front())
        {
          this->Cells[task.triangle] = corners;
          continue;
        }
        this->Cells.push_back(corners);
        result.surface.originalTriangle.push_back(task.triangle);
      }
      if (!good && cells.size() > 1)
      {
        result.failed.push_back(task.triangle);
      }
    }
  }

  static bool hasArea(const std::array<Point3, 3>& p, const Point3& normal)
  {
    const double longest =
      std::max({ (p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm() });
    if (!(longest > 0.0))
    {
      return false;
    }
    const Point3 u = (p[1] - p[0]) / longest;
    const Point3 v = (p[2] - p[0]) / longest;
    return u.cross(v).norm() > surelyHigh && u.cross(v).dot(normal) > 0.0;
  }

  void collectChains(SplitSurface& result) const
  {
    for (std::size_t p = 0; p < this->Paths.size(); ++p)
    {
      Indices chain{ this->Nodes.vertex(this->Starts[p]) };
      for (const Stretch& stretch : this->Paths[p])
      {
        for (Index node : this->nodesOf(stretch))
        {
          if (this->Nodes.vertex(node) != chain.back())
          {
            chain.push_back(this->Nodes.vertex(node));
          }
        }
      }
      result.chains.push_back(std::move(chain));
    }
  }

  /// All nodes along a stretch, with both ends.
  Indices nodesOf(const Stretch& stretch) const
  {
    Indices nodes;
    if (stretch.edge == none)
    {
      const FaceTask& task = this->Tasks[stretch.task];
      const std::unordered_map<Index, Index>& local = task.vertexOfNode;
      for (Index v : task.triangulation->chain(local.at(stretch.from), local.at(stretch.to)))
      {
        nodes.push_back(task.nodeOfVertex[v]);
      }
      return nodes;
    }
    const Index low = edgeOf(this->Mesh, stretch.edge);
    const double from = this->fractionAlong(low, stretch.from);
    const double to = this->fractionAlong(low, stretch.to);
    nodes.push_back(stretch.from);
    std::vector<NodeOnEdge> between = this->Nodes.along(low);
    if (from > to)
    {
      std::reverse(between.begin(), between.end());
    }
    for (const NodeOnEdge& node : between)
    {
      if (node.fraction > std::min(from, to) && node.fraction < std::max(from, to))
      {
        nodes.push_back(node.node);
      }
    }
    nodes.push_back(stretch.to);
    return nodes;
  }

  double fractionAlong(Index low, Index id) const
  {
    const SurfacePoint point = this->Nodes.point(id);
    return point.type == SurfacePointType::Edge ? point.weights[1]
      : id == this->Mesh.from(low)              ? 0.0
                                                : 1.0;
  }

  const TriangleMesh& Mesh;
  const SnapDistance& Snap;
  SplitNodes Nodes;
  std::unordered_map<Index, Index> TaskOfTriangle;
  std::vector<FaceTask> Tasks;
  std::vector<std::vector<Stretch>> Paths;
  Indices Starts;
  Triangles Cells;
};
}

SplitSurface splitSurface(
  const TriangleMesh& mesh, const SnapDistance& snap, const std::vector<SurfacePath>& paths)
{
  Splitter splitter(mesh, snap);
  for (const SurfacePath& path : paths)
  {
    splitter.addPath(path);
  }
  return splitter.run();
}
}
