// SPDX-License-Identifier: BSD-3-Clause
// Statuses of Documentation/errors.md. Those of flattened pieces are made in
// Testing/Python/TestRemedies.py, of surfaces in TestSurfacePreparation, of curves in
// TestCurveImprint.
#include "Base/Status.h"
#include "Flattened.h"
#include "Imprint/CurveImprint.h"
#include "StatusTesting.h"

#include <cfenv>
#include <fstream>
#include <sstream>

using namespace flattening;
using namespace statustesting;
using namespace testmeshes;

namespace
{
/// Height over the longest edge.
double height(const TriangleMesh& mesh, Index t)
{
  const Triangle& c = mesh.triangle(t);
  const Point3 u = mesh.point(c[1]) - mesh.point(c[0]);
  const Point3 v = mesh.point(c[2]) - mesh.point(c[0]);
  return u.cross(v).norm() / std::max({ u.norm(), v.norm(), (v - u).norm() });
}

/// A sheet of 4 x 4 quads some of whose rows are 1e-10 to 1e-12 high, with a curve through three
/// places inside its triangles.
struct ThinSheet
{
  static constexpr Index rows = 4;
  double thin;
  std::vector<double> shift;
  std::vector<bool> thinRow;
  Triangles triangles = gridTriangles(rows, rows);
  struct Place
  {
    Index triangle;
    double a;
    double b;
  };
  std::array<Place, 3> places{};

  explicit ThinSheet(std::mt19937& random)
  {
    const auto fraction = [&random] { return random() / 4294967296.0; };
    this->thin = std::pow(10.0, -10.0 - 1.9 * fraction());
    for (Index j = 0; j <= rows; ++j)
    {
      this->thinRow.push_back(random() % 2 == 0);
      for (Index i = 0; i <= rows; ++i)
      {
        this->shift.push_back(0.2 * fraction());
      }
    }
    for (Place& place : this->places)
    {
      place.triangle = static_cast<Index>(random() % this->triangles.size());
      place.a = fraction();
      place.b = (1.0 - place.a) * fraction();
    }
  }

  Points3 points(double thinHeight) const
  {
    Points3 result;
    double y = 0.0;
    for (Index j = 0; j <= rows; ++j)
    {
      for (Index i = 0; i <= rows; ++i)
      {
        result.push_back(Point3(i + this->shift[(rows + 1) * j + i], y, 0.1 * std::sin(i * y)));
      }
      y += this->thinRow[j] ? thinHeight : 1.0;
    }
    return result;
  }

  /// The curve on the sheet with thin rows of this height.
  Status imprint(double thinHeight, double snap) const
  {
    const Points3 at = this->points(thinHeight);
    Polyline line;
    for (const Place& place : this->places)
    {
      const Triangle& c = this->triangles[place.triangle];
      line.points.push_back(
        place.a * at[c[0]] + place.b * at[c[1]] + (1.0 - place.a - place.b) * at[c[2]]);
    }
    ImprintOptions options;
    options.snap = snap;
    return imprintCurves(prepareSurface(at, this->triangles).mesh, { line }, options).status;
  }
};
}

TEST(Errors, EveryStatusIsDocumented)
{
  std::ifstream file(std::string(FLATTENING_DATA_DIR) + "/../Documentation/errors.md");
  std::stringstream text;
  text << file.rdbuf();
  ASSERT_FALSE(text.str().empty());
  for (int code = 1; code <= static_cast<int>(StatusCode::FileNotWritten); ++code)
  {
    const std::string name = statusName(static_cast<StatusCode>(code));
    EXPECT_NE(text.str().find("| `" + name + "` |"), std::string::npos) << name;
  }
}

TEST(Errors, OfTrianglesTooThinToBeSplit)
{
  // Few such cases fail: rounding decides. These are some of a thousand seeded ones, all tried
  // below.
  std::mt19937 random(1);
  int failures = 0;
  int helped = 0;
  for (int trial = 0; trial < 1000; ++trial)
  {
    const ThinSheet sheet(random);
    const PreparedSurface prepared = prepareSurface(sheet.points(sheet.thin), sheet.triangles);
    ASSERT_TRUE(prepared.status.ok()) << prepared.status.message;
    const Status status = sheet.imprint(sheet.thin, 0.0);
    if (status.code != StatusCode::NumericalFailure)
    {
      EXPECT_TRUE(status.ok() || status.code == StatusCode::CurveLeavesSurface) << status.message;
      continue;
    }
    ++failures;
    // What it names is too thin: no triangle of the other rows is.
    EXPECT_FALSE(status.ids.empty());
    EXPECT_EQ(status.ids.kind, ElementKind::Cells);
    EXPECT_TRUE(has(status, Remedy::RaiseSnapTolerance));
    for (const std::int64_t t : status.ids.values)
    {
      EXPECT_LT(height(prepared.mesh, static_cast<Index>(t)), 1e-9) << "trial " << trial;
    }
    // The ways out that the message names: the first always is one, the second mostly.
    EXPECT_TRUE(sheet.imprint(1.0, 0.0).ok()) << "trial " << trial << ", remeshed";
    helped += sheet.imprint(sheet.thin, 0.5).ok() ? 1 : 0;
  }
  EXPECT_GE(failures, 10);
  EXPECT_GT(2 * helped, failures) << "a larger snap distance seldom is a way out";
}

TEST(Status, TheWorstOfSeveralIsByHowLittleItsPieceIsOfUse)
{
  const std::vector<StatusCode> fromBad{ StatusCode::NumericalFailure, StatusCode::LengthError,
    StatusCode::IncompatibleKeys, StatusCode::NotConverged, StatusCode::FlippedTriangles,
    StatusCode::Overlap, StatusCode::Ok };
  for (std::size_t k = 0; k + 1 < fromBad.size(); ++k)
  {
    EXPECT_GT(severity(fromBad[k]), severity(fromBad[k + 1])) << statusName(fromBad[k]);
  }
}

TEST(Status, AListOfIdsIsCutWhereItGetsLongAndSaysHowManyAreLeft)
{
  EXPECT_EQ(listIds(Indices{}, 3), "");
  EXPECT_EQ(listIds(Indices{ 4, 7 }, 3), "4, 7");
  EXPECT_EQ(listIds(Indices{ 4, 7, 9, 11, 12 }, 3), "4, 7, 9 and 2 more");
}

TEST(FloatingPointTraps, AreOnInThisProgram)
{
  const int wanted = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  EXPECT_EQ(fegetexcept() & wanted, wanted);
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
