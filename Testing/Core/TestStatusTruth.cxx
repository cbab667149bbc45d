// SPDX-License-Identifier: BSD-3-Clause
// What statuses say is the case: which of several, which wires and keys, and a remedy that is one.
#include "Flattened.h"
#include "StatusTesting.h"

using namespace flattening;
using namespace statustesting;
using namespace testmeshes;

TEST(StatusTruth, WiresThatMissTheirLengthsAreNamedWithTheirErrors)
{
  for (const Scheme scheme : { Scheme::Global, Scheme::Isometric, Scheme::Progressive })
  {
    SCOPED_TRACE(static_cast<int>(scheme));
    FlatteningOptions options = withScheme(scheme);
    const Surface surface = pyramid(1.0);
    const FlatteningResult result = flatten(surface, options);
    const Status& status = result.status;
    EXPECT_EQ(codeOf(status), StatusCode::LengthError);
    EXPECT_EQ(status.ids.kind, ElementKind::Curves);
    ASSERT_FALSE(status.ids.empty());
    double worst = 0.0;
    for (const CurveReport& report : result.curves)
    {
      worst = std::max(worst, report.error);
    }
    const auto first = static_cast<std::size_t>(status.ids.values.front());
    EXPECT_EQ(result.curves[first].error, worst) << "the worst curve first";
    for (const std::int64_t c : status.ids.values)
    {
      const CurveReport& report = result.curves[static_cast<std::size_t>(c)];
      EXPECT_GT(report.error, options.lengthTolerance);
      EXPECT_NE(
        status.message.find("\"" + report.name + "\" by up to " + shortNumber(report.error)),
        std::string::npos)
        << status.message;
    }
    EXPECT_TRUE(has(status, Remedy::ReleaseCurves));
  }
}

TEST(StatusTruth, RoundingOfCoordinatesIsNoErrorOfLengths)
{
  // An edge of the boundary a millionth as long as the others, which coordinates of 40 units can
  // give to about 4e-9 of its length.
  double worst = 0.0;
  for (const double shortest : { 1e-5, 2e-6, 1e-6 })
  {
    for (const double scale : { 1.0, 1000.0 / 3.0 })
    {
      SCOPED_TRACE(shortest);
      const Surface surface = patch(40, 4, [&](double i, double j) {
        const double x = i < 37.5 ? i : i - 1.0 + shortest;
        return Point3(scale * Point3(x, j, 0.05 * std::sin(x) * j * (4.0 - j)));
      });
      const FlatteningResult result = flattenOk(surface);
      worst = std::max(worst, result.pieces[0].quality.maximumEdgeLengthError);
    }
  }
  EXPECT_GT(worst, FlatteningOptions().lengthTolerance) << "reported as it is";
}

TEST(StatusTruth, TheBoundaryThatMissesItsLengthIsNamedByAnEdge)
{
  FlatteningOptions strict;
  strict.lengthTolerance = 0.0;
  const Surface surface = cushion(6, 6, 0.4);
  const Status status = flattenSurface(surface.mesh, {}, strict, {}).status;
  EXPECT_EQ(codeOf(status), StatusCode::LengthError);
  EXPECT_NE(status.message.find("the boundary"), std::string::npos) << status.message;
  EXPECT_EQ(status.ids.kind, ElementKind::Edges);
  ASSERT_EQ(status.ids.values.size(), 2U);
  const auto a = static_cast<Index>(status.ids.values[0]);
  const auto b = static_cast<Index>(status.ids.values[1]);
  EXPECT_TRUE(surface.mesh.find(a, b) != none || surface.mesh.find(b, a) != none);
}

TEST(StatusTruth, MoreIterationsAreAdvisedOnlyWhereTheyChangeTheResult)
{
  for (const Scheme scheme : { Scheme::Global, Scheme::Isometric })
  {
    SCOPED_TRACE(static_cast<int>(scheme));
    FlatteningOptions options = withScheme(scheme);
    const Surface impossible = pyramid(1.0);
    const Status stuck = flatten(impossible, options).status;
    EXPECT_FALSE(stuck.ok());
    EXPECT_FALSE(has(stuck, Remedy::AllowAngleIterations)) << stuck.message;
    EXPECT_FALSE(has(stuck, Remedy::AllowIsometricIterations)) << stuck.message;

    const bool isometric = scheme == Scheme::Isometric;
    // The crossing arcs take the wires' angles fifteen iterations.
    (isometric ? options.isometric.maximumIterations : options.angles.maximumIterations) = 2;
    const Surface slow = quarterSphereWithTwoArcs();
    const Status ranOut = flatten(slow, options).status;
    EXPECT_TRUE(
      has(ranOut, isometric ? Remedy::AllowIsometricIterations : Remedy::AllowAngleIterations))
      << ranOut.message;
  }
}

TEST(StatusTruth, TheRunTellsTheWorstOfItsPieces)
{
  const std::vector<StatusCode> fromBad{ StatusCode::NumericalFailure, StatusCode::LengthError,
    StatusCode::IncompatibleKeys, StatusCode::NotConverged, StatusCode::FlippedTriangles,
    StatusCode::Overlap, StatusCode::Ok };
  for (std::size_t k = 0; k + 1 < fromBad.size(); ++k)
  {
    EXPECT_GT(severity(fromBad[k]), severity(fromBad[k + 1])) << statusName(fromBad[k]);
  }
  for (const Surface& surface :
    { together({ pyramid(1.0), staircase() }), together({ staircase(), pyramid(1.0) }) })
  {
    const FlatteningResult result = flatten(surface);
    ASSERT_EQ(result.pieces.size(), 2U);
    const bool pyramidFirst = result.pieces[0].triangles == 4;
    EXPECT_EQ(result.pieces[pyramidFirst ? 0 : 1].status.code, StatusCode::LengthError);
    EXPECT_EQ(result.pieces[pyramidFirst ? 1 : 0].status.code, StatusCode::Overlap);
    EXPECT_EQ(result.status.code, StatusCode::LengthError);
    EXPECT_EQ(result.status.message, result.pieces[pyramidFirst ? 0 : 1].status.message);
    EXPECT_EQ(result.status.ids, result.pieces[pyramidFirst ? 0 : 1].status.ids);
  }
}

TEST(StatusTruth, KeysThatCannotKeepTheirShapesAreNamedWithAWayOut)
{
  // A ring inside, the boundary from corner to corner, and a line across the middle.
  const Surface bare = cushion(8, 8, 0.4);
  const auto at = [](Index i, Index j) { return j * 9 + i; };
  const FeatureCurve ring = curveOf(CurveType::Key, "ring",
    { at(2, 2), at(3, 2), at(4, 2), at(5, 2), at(6, 2), at(6, 3), at(6, 4), at(6, 5), at(6, 6),
      at(5, 6), at(4, 6), at(3, 6), at(2, 6), at(2, 5), at(2, 4), at(2, 3), at(2, 2) });
  const FeatureCurve edge = rowCurve(8, 0, CurveType::Key);
  const FeatureCurve line = rowCurve(8, 4, CurveType::Key);
  Index clashes = 0;
  for (const Scheme scheme : { Scheme::Global, Scheme::Isometric, Scheme::Progressive })
  {
    for (const FeatureCurve& key : { ring, edge, line })
    {
      for (const int shape : { 0, 1, 2 })
      {
        Surface surface = bare;
        surface.curves = { key };
        surface.curves[0].keyShape = static_cast<KeyShape>(shape);
        for (std::size_t k = 0; k < key.vertices.size(); ++k)
        {
          // Of the planar shapes: to and fro, which folds each triangle beside it over.
          surface.curves[0].planarShape.emplace_back(k % 2 == 0 ? 0.0 : 1.0, 1e-3 * k);
        }
        FlatteningOptions options = withScheme(scheme);
        const FlatteningResult result = flatten(surface, options);
        const Status& status = result.status;
        SCOPED_TRACE(key.name + ", shape " + std::to_string(shape) + ", scheme " +
          std::to_string(static_cast<int>(scheme)) + ": " + statusName(status.code) + ": " +
          status.message);
        codeOf(status);
        if (status.ok())
        {
          continue;
        }
        ++clashes;
        EXPECT_EQ(status.code, StatusCode::IncompatibleKeys);
        EXPECT_NE(status.message.find("\"" + key.name + "\""), std::string::npos);
        EXPECT_EQ(status.ids, (ElementIds{ ElementKind::Curves, Indices{ 0 } }));
        EXPECT_TRUE(has(status, Remedy::MakeAccessory));
        EXPECT_TRUE(result.curves[0].released);
        EXPECT_LE(result.pieces[0].quality.maximumEdgeLengthError, options.lengthTolerance);
      }
    }
  }
  EXPECT_GT(clashes, 5);
}

TEST(StatusTruth, KeysWhoseReleaseDoesNotHelpAreAllNamedAndKept)
{
  // The patch in the middle has all its angles prescribed, and they are not those of a flat one. In
  // a corner, away from the keys, a spike all of whose edges are wires cannot be laid flat.
  Surface surface = cushion(10, 10, 0.3);
  const Index top = 12;
  surface.mesh = moved(surface.mesh, [spike = surface.mesh.point(top)](const Point3& p) -> Point3 {
    return p == spike ? Point3(p + Point3::UnitZ()) : p;
  });
  surface.curves = { rowCurve(10, 4, CurveType::Key), rowCurve(10, 8, CurveType::Key),
    columnCurve(10, 10, 4, CurveType::Key), columnCurve(10, 10, 8, CurveType::Key) };
  FeatureCurve ring = accessory("ring", {});
  Index h = surface.mesh.outgoing(top);
  do
  {
    const Index around = surface.mesh.to(h);
    ring.vertices.push_back(around);
    surface.curves.push_back(accessory("ridge " + std::to_string(around), { top, around }));
    h = surface.mesh.counterClockwise(h);
  } while (h != surface.mesh.outgoing(top));
  ring.vertices.push_back(ring.vertices.front());
  surface.curves.push_back(ring);

  FlatteningOptions options = withScheme(Scheme::Global);
  const FlatteningResult result = flatten(surface, options);
  const Status& status = result.status;
  EXPECT_EQ(codeOf(status), StatusCode::LengthError);
  EXPECT_NE(status.message.find("giving up all of them does not help alone"), std::string::npos)
    << status.message;
  for (std::size_t c = 0; c < 4; ++c)
  {
    EXPECT_NE(status.message.find('"' + surface.curves[c].name + '"'), std::string::npos);
    EXPECT_FALSE(result.curves[c].released);
  }
  EXPECT_TRUE(has(status, Remedy::MakeAccessory));
  // Without the spike their release does help.
  surface.curves.resize(4);
  const FlatteningResult without = flatten(surface, options);
  EXPECT_EQ(without.status.code, StatusCode::IncompatibleKeys) << without.status.message;
  EXPECT_FALSE(without.pieces[0].released.empty());
}
