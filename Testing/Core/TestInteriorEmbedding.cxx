// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/InteriorEmbedding.h"
#include "Embedding/RigidEmbedding.h"
#include "Embedding/Untangling.h"
#include "Flattened.h"
#include "Quality/FlatteningQuality.h"
#include "Reference/InteriorRelaxation.h"
#include "WiredSurface.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
constexpr InteriorMethod allMethods[] = { InteriorMethod::Laplacian, InteriorMethod::Relaxation,
  InteriorMethod::AsRigidAsPossible };

InteriorOptions with(InteriorMethod method)
{
  InteriorOptions options;
  options.method = method;
  return options;
}

/// A cushion with wires across it, in several patches.
Surface wiredCushion(double height = 0.4)
{
  return withCurves(cushion(12, 9, height), { rowCurve(12, 4), columnCurve(12, 9, 5) });
}

/// Wire vertices from a map of the surface to the plane; the rest at zero, as layOutWires leaves
/// it.
Points2 pinnedBy(const WiredSurface& wired, const std::function<Point2(const Point3&)>& map)
{
  Points2 positions(wired.piece.mesh.vertexCount(), Point2::Zero());
  for (Index v : wired.network.hostVertices)
  {
    positions[v] = map(wired.piece.mesh.point(v));
  }
  return positions;
}

Point2 shadow(const Point3& p)
{
  return { 1.05 * p.x() + 0.1 * p.y() * p.y(), p.y() + 0.1 * p.x() };
}
}

TEST(InteriorEmbedding, LaplacianPutsEachVertexAtTheMeanOfEquation11)
{
  const WiredSurface wired(wiredCushion());
  const TriangleMesh& mesh = wired.piece.mesh;
  ASSERT_EQ(wired.network.patchCount, 4);
  Points2 positions = pinnedBy(wired, shadow);
  ASSERT_TRUE(
    placeInterior(wired.piece, wired.network, with(InteriorMethod::Laplacian), {}, positions)
      .status.ok());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (wired.network.hostOfVertex[v] != none)
    {
      continue;
    }
    Point2 sum = Point2::Zero();
    double weight = 0.0;
    Index h = mesh.outgoing(v);
    do
    {
      sum += positions[mesh.to(h)] / mesh.length(h);
      weight += 1.0 / mesh.length(h);
      h = mesh.counterClockwise(h);
    } while (h != mesh.outgoing(v));
    EXPECT_LT((sum / weight - positions[v]).norm(), 1e-14);
  }
}

TEST(InteriorEmbedding, RelaxationConvergesToTheDirectSolution)
{
  const WiredSurface wired(wiredCushion());
  Points2 direct = pinnedBy(wired, shadow);
  placeInterior(wired.piece, wired.network, with(InteriorMethod::Laplacian), {}, direct);
  for (double factor : { 0.7, 1.0, 1.5, 1.9 })
  {
    Points2 relaxed = pinnedBy(wired, shadow);
    InteriorOptions options = with(InteriorMethod::Relaxation);
    options.relaxation = factor;
    options.movement = 1e-13; // rounding moves vertices by a tenth of that
    options.maximumIterations = 3000;
    ASSERT_TRUE(placeInterior(wired.piece, wired.network, options, {}, relaxed).status.ok());
    EXPECT_LT(largestDistance(relaxed, direct), 1e-12) << factor;
  }
}

TEST(InteriorEmbedding, AsRigidAsPossibleReachesTheKnownQuarterSphere)
{
  FlatteningOptions options = withScheme(Scheme::Global);
  options.interior = with(InteriorMethod::AsRigidAsPossible);
  const FlatteningResult result = flatten(quarterSphere(), options);
  ASSERT_EQ(result.pieces.size(), 1u) << result.status.message;
  EXPECT_NEAR(result.pieces[0].quality.angleError, 0.0779, 0.00005);
  EXPECT_NEAR(result.pieces[0].quality.globalHomogeneity, 0.786, 0.0005);
}

TEST(InteriorEmbedding, StaysFiniteOnCollapsedMirroredAndTornWires)
{
  const std::function<Point2(const Point3&)> maps[] = {
    [](const Point3&) { return Point2(0.3, 0.4); },
    [](const Point3& p) { return Point2(-p.x(), p.y()); },
    [](const Point3& p) { return Point2(p.x(), 0.0); },
    [](const Point3& p) { return Point2(1e6 * p.x(), 1e-6 * p.y()); },
    [](const Point3& p) { return Point2(std::sin(40.0 * p.x()), std::cos(70.0 * p.y())); },
  };
  const WiredSurface wired(wiredCushion());
  for (InteriorMethod method : allMethods)
  {
    for (const auto& map : maps)
    {
      Points2 positions = pinnedBy(wired, map);
      const auto result = placeInterior(wired.piece, wired.network, with(method), {}, positions);
      EXPECT_FALSE(result.status.refused());
      for (const Point2& p : positions)
      {
        EXPECT_TRUE(p.allFinite());
      }
    }
  }
}

TEST(InteriorEmbedding, SliversDoNotSpoilTheirNeighbours)
{
  // An inner row of vertices moved to within a hair of the next one.
  for (double hair : { 1e-3, 1e-6, 1e-9, 1e-11 })
  {
    const auto place = [hair](double i, double j) { return Point2(i, j == 3.0 ? 4.0 - hair : j); };
    const Surface surface = patch(
      8, 7, [&](double i, double j) { return Point3(place(i, j).x(), place(i, j).y(), 0.0); },
      place);
    const WiredSurface wired(surface);
    Points2 positions = pinnedBy(wired, [](const Point3& p) { return Point2(p.x(), p.y()); });
    const auto result = placeInterior(
      wired.piece, wired.network, with(InteriorMethod::AsRigidAsPossible), {}, positions);
    EXPECT_FALSE(result.status.refused());
    for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
    {
      EXPECT_LT((positions[v] - wired.piece.mesh.point(v).head<2>()).norm(), 1e-5) << hair;
    }
  }
}

TEST(RigidEmbedding, EndsWhereTheLocalGlobalMethodEnds)
{
  // The classic iteration, with dense matrices and to its bitter end, from positions that stretch
  // and shear a cushion.
  const WiredSurface wired(cushion(7, 6, 0.5));
  InteriorSystem system;
  system.update(collectInteriorPatches(wired.piece, wired.network).front(), wired.piece.mesh);
  const Indices& vertices = system.patch().vertices;
  const Index free = system.patch().freeCount;
  Eigen::MatrixXd start(static_cast<Eigen::Index>(vertices.size()), 2);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Point3& p = wired.piece.mesh.point(vertices[i]);
    start.row(static_cast<Eigen::Index>(i)) << 1.1 * p.x() + 0.2 * p.y(), 0.8 * p.y();
  }
  RigidEmbedding embedding(system, system.factor(InteriorWeights::Cotangent, {}), start, {});
  for (int k = 0; k < 50 && embedding.iterate(0.0) == RigidEmbedding::State::Running; ++k)
  {
  }
  const auto count = static_cast<Eigen::Index>(vertices.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(count, count);
  std::vector<std::array<Complex, 3>> flat; // corners of each triangle laid into the plane
  const std::vector<EdgeWeights> weights = system.edgeWeights(InteriorWeights::Cotangent);
  const auto forEdges = [&](const auto& visit) {
    for (std::size_t t = 0; t < weights.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        visit(t, k, (k + 1) % 3, (k + 2) % 3);
      }
    }
  };
  for (const Triangle& c : system.patch().triangles)
  {
    const Point3& origin = wired.piece.mesh.point(vertices[c[0]]);
    const Point3 u = wired.piece.mesh.point(vertices[c[1]]) - origin;
    const Point3 v = wired.piece.mesh.point(vertices[c[2]]) - origin;
    flat.push_back({ 0.0, u.norm(), Complex(u.dot(v), u.cross(v).norm()) / u.norm() });
  }
  forEdges([&](std::size_t t, int k, int a, int b) {
    const Triangle& c = system.patch().triangles[t];
    for (const auto& [i, j] : { std::pair(c[a], c[b]), std::pair(c[b], c[a]) })
    {
      stiffness(i, i) += weights[t][k];
      stiffness(i, j) -= weights[t][k];
    }
  });
  const Eigen::LLT<Eigen::MatrixXd> global(stiffness.topLeftCorner(free, free));
  Eigen::VectorXcd positions = start.col(0) + Complex(0.0, 1.0) * start.col(1);
  for (int iteration = 0; iteration < 2000; ++iteration)
  {
    std::vector<Complex> turn(flat.size(), 0.0);
    forEdges([&](std::size_t t, int k, int a, int b) {
      const Triangle& c = system.patch().triangles[t];
      turn[t] +=
        weights[t][k] * std::conj(flat[t][a] - flat[t][b]) * (positions[c[a]] - positions[c[b]]);
    });
    Eigen::VectorXcd pull = Eigen::VectorXcd::Zero(count);
    forEdges([&](std::size_t t, int k, int a, int b) {
      const Triangle& c = system.patch().triangles[t];
      const Complex side = weights[t][k] * turn[t] / std::abs(turn[t]) * (flat[t][a] - flat[t][b]);
      pull[c[a]] += side;
      pull[c[b]] -= side;
    });
    pull -= stiffness.rightCols(count - free) * positions.tail(count - free);
    positions.head(free).real() = global.solve(pull.head(free).real());
    positions.head(free).imag() = global.solve(pull.head(free).imag());
  }
  EXPECT_LT((positions.real() - embedding.positions().col(0)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((positions.imag() - embedding.positions().col(1)).cwiseAbs().maxCoeff(), 1e-9);
}

namespace
{
/// Per vertex of the piece.
Points2 unrolled(const WiredSurface& wired, const Surface& surface)
{
  Points2 positions;
  for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
  {
    positions.push_back(surface.unrolled[wired.original(v)]);
  }
  return positions;
}

/// A flat patch whose interior is scattered, and whose wires are bent into a deep notch.
Points2 tangledPositions(const WiredSurface& wired, const Points2& flat, double notch)
{
  Points2 positions;
  for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
  {
    const Point2 p = flat[wired.original(v)];
    const bool onWire = wired.network.hostOfVertex[v] != none;
    const Point2 bent(p.x(), p.y() - notch * std::exp(-(p.x() - 5.0) * (p.x() - 5.0)));
    positions.push_back(onWire ? bent : Point2(5.0 + std::sin(17.0 * v), 5.0 + std::cos(31.0 * v)));
  }
  return positions;
}
}

TEST(Untangling, ScatteredInteriorsInsideASimpleLoopEndWithoutFlips)
{
  for (double notch : { 0.0, 1.5 })
  {
    const Surface surface = flatPatch(10, 10);
    const WiredSurface wired(surface);
    Points2 positions = tangledPositions(wired, surface.unrolled, notch);
    ASSERT_GT(countFlipped(wired.piece.mesh, positions), 20);
    const Points2 before = positions;
    const UntanglingResult result = untangleInterior(wired.piece, wired.network, {}, positions);
    EXPECT_TRUE(result.status.ok());
    EXPECT_EQ(result.patches, (Indices{ 0 }));
    EXPECT_TRUE(result.tangled.empty());
    EXPECT_EQ(countFlipped(wired.piece.mesh, positions), 0);
    for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
    {
      if (wired.network.hostOfVertex[v] != none)
      {
        EXPECT_EQ(positions[v], before[v]);
      }
    }
  }
}

TEST(Untangling, SaysWhichPatchCannotBeHelped)
{
  // The boundary runs clockwise: every triangle must be flipped.
  const Surface surface = flatPatch(4, 4);
  const WiredSurface wired(surface);
  Points2 positions = unrolled(wired, surface);
  for (Point2& p : positions)
  {
    p.x() = -p.x();
  }
  const UntanglingResult result = untangleInterior(wired.piece, wired.network, {}, positions);
  EXPECT_EQ(result.tangled, (Indices{ 0 }));
  for (const Point2& p : positions)
  {
    EXPECT_TRUE(p.allFinite());
  }
}

TEST(Untangling, MovesWhatLiesAroundFoldsAloneWhereThatIsAskedFor)
{
  const Surface surface = flatPatch(30, 30);
  const WiredSurface wired(surface);
  Points2 positions = unrolled(wired, surface);
  positions[wired.vertex(15 * 31 + 15)] += Point2(2.5, 0.3);
  ASSERT_GT(countFlipped(wired.piece.mesh, positions), 0);
  const Points2 before = positions;
  UntanglingOptions options;
  options.nearby = true;
  const UntanglingResult result =
    untangleInterior(wired.piece, wired.network, {}, positions, options);
  EXPECT_TRUE(result.tangled.empty());
  EXPECT_EQ(countFlipped(wired.piece.mesh, positions), 0);
  for (Index v = 0; v < wired.piece.mesh.vertexCount(); ++v)
  {
    if ((before[v] - Point2(15.0, 15.0)).norm() > 13.0)
    {
      EXPECT_EQ(positions[v], before[v]);
    }
  }
}
