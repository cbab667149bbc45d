// SPDX-License-Identifier: BSD-3-Clause
// Flat pieces that no flattening should give, through every writer: each is drawn or refused with
// words.
#include "Fairing/FairBorders.h"
#include "Formats/PatternFile.h"
#include "HostileSurface.h"
#include "Sewing/PieceSewing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ctime>

#ifdef __linux__
#include <sys/resource.h>
#endif

using namespace hostile;
using namespace flattening::pattern;

namespace
{
constexpr double secondsEach = 60.0; ///< of the processor, for all formats of a case

PatternSource sourceOf(const FlatteningResult& result)
{
  PatternSource source;
  source.positions = result.positions;
  source.inSpace = result.cut->mesh.points();
  source.triangles = result.cut->mesh.triangles();
  source.pieceOfTriangle = result.cut->pieceOfTriangle;
  for (const Wire& wire : result.wires)
  {
    if (wire.connector)
    {
      continue;
    }
    const bool border = wire.curve == none;
    const WireType types[] = { WireType::Accessory, WireType::Key, WireType::Dart, WireType::Seam };
    source.wires.push_back({ wire.vertices,
      border ? WireType::Boundary : types[static_cast<std::size_t>(wire.type)], wire.curve,
      wire.piece, border ? "boundary" : result.curves[static_cast<std::size_t>(wire.curve)].name });
  }
  const TriangleMesh& mesh = result.cut->mesh;
  for (const SeamPair& pair : result.cut->seamPairs)
  {
    source.sewn.push_back({ { mesh.from(pair.first), mesh.to(pair.first) },
      { mesh.to(pair.second), mesh.from(pair.second) }, false });
  }
  return source;
}

double sizeOf(const Points2& points)
{
  Eigen::AlignedBox2d box;
  for (const Point2& p : points)
  {
    box.extend(p);
  }
  return box.diagonal().norm();
}

/// Breaks positions in one of the ways in which flattenings fail. \return its name
std::string breakPieces(std::mt19937& random, PatternSource& source)
{
  const auto unit = [&random] { return static_cast<double>(random()) / 4294967295.0; };
  Points2& points = source.positions;
  const double size = sizeOf(points);
  const auto pick = [&] { return random() % points.size(); };
  const auto each = [&](
                      const auto& change) { std::for_each(points.begin(), points.end(), change); };
  const std::vector<SourceWire>& wires = source.wires;
  const Indices border = wires.empty() ? Indices() : wires[random() % wires.size()].points;
  switch (random() % 12)
  {
    case 0:
      return "as it is";
    case 1: // a part of a border in one point
      for (std::size_t k = 0; k < border.size() && k < 2 + random() % 12; ++k)
      {
        points[border[k]] = points[border[0]];
      }
      return "edges without length";
    case 2:
      for (const Index v : border)
      {
        points[v] = points[border.front()];
      }
      return "a border in one point";
    case 3:
      for (const Index v : border)
      {
        points[v] = points[border.front()] +
          (points[border.back()] - points[border.front()]) * unit() * std::pow(10.0, -6.0 * unit());
      }
      return "a border in a segment";
    case 4:
      for (std::size_t k = 0; k < 1 + random() % 6; ++k)
      {
        const std::size_t v = pick();
        points[v] = points[pick()] +
          Point2(unit() - 0.5, unit() - 0.5) * size * std::pow(10.0, -1.0 - 14.0 * unit());
      }
      return "tiny edges";
    case 5:
    {
      const double noise = size * std::pow(10.0, -4.0 * unit());
      each([&](Point2& p) { p += noise * Point2(unit() - 0.5, unit() - 0.5); });
      return "lengths that are off, and flips";
    }
    case 6:
      each([&](Point2& p) { p.x() *= std::pow(10.0, -15.0 * unit()); });
      return "pressed to nothing";
    case 7:
      std::shuffle(points.begin(), points.end(), random);
      return "shuffled";
    case 8:
    {
      const double angle = 12.0 * (unit() - 0.5);
      each([&](Point2& p) { p = Eigen::Rotation2Dd(angle * p.norm() / size) * p; });
      return "rolled up over itself";
    }
    case 9:
    {
      const double factor = std::pow(10.0, 24.0 * (unit() - 0.5));
      each([=](Point2& p) { p *= factor; });
      return "of any size";
    }
    case 10:
      each([&](Point2& p) { p += size * std::pow(10.0, 12.0 * unit()) * Point2(1.0, -1.0); });
      return "far away";
    default:
      for (const Triangle& t : source.triangles)
      {
        if (random() % 4 == 0)
        {
          std::swap(points[t[0]], points[t[1]]);
        }
      }
      return "flips";
  }
}

FileOptions randomOptions(std::mt19937& random, const PatternSource& source)
{
  const auto any = [&random](std::initializer_list<double> values) {
    return values.begin()[random() % values.size()];
  };
  const auto oneIn = [&random](unsigned count) { return random() % count == 0; };
  FileOptions options;
  PatternOptions& pattern = options.pattern;
  pattern.unit = static_cast<Unit>(random() % 4);
  pattern.allowance = any({ 0.0, 0.0, 6.0, 10.0, 80.0 });
  pattern.fairTolerance = any({ 0.0, 0.2, 0.2, 0.2, 3.0, 100.0 });
  pattern.symmetrize = pattern.fairTolerance > 0.0 && oneIn(3);
  pattern.notchSpacing = any({ 0.0, 100.0, 100.0, 7.0 });
  pattern.notchCorners = oneIn(3);
  pattern.notchCurveEnds = oneIn(3);
  pattern.cutDartsOut = oneIn(2);
  pattern.dartTip = oneIn(6) ? 3.0 : 0.0;
  pattern.cutOnFold = oneIn(3);
  pattern.pairs = oneIn(3);
  pattern.quantity = static_cast<int>(1 + random() % 3);
  options.laserColors = oneIn(2);
  options.cutterStyle = oneIn(2);
  options.walkTable = oneIn(2);
  options.pages.paper = static_cast<PaperSize>(random() % 5);
  options.pages.maximumPages = 20;
  if (!source.wires.empty() && oneIn(4))
  {
    const std::string& name = source.wires[random() % source.wires.size()].name;
    pattern.allowanceOfCurve[name] = any({ 0.0, 15.0 });
    pattern.fairToleranceOfCurve[name] = any({ 0.0, 1.0 });
  }
  return options;
}

/// Whether the text has a number that is none: a word "nan" or "inf".
bool hasNoNumber(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const std::string word : { "nan", "inf" })
  {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    {
      const auto isLetter = [&text](std::size_t k) {
        return k < text.size() && std::isalpha(static_cast<unsigned char>(text[k])) != 0;
      };
      if (!isLetter(at - 1) && !isLetter(at + word.size()))
      {
        return true;
      }
    }
  }
  return false;
}

void expectWords(const Status& status)
{
  EXPECT_TRUE(status.ok() || !status.message.empty());
  EXPECT_FALSE(hasNoNumber(status.message)) << status.message;
}

/// All formats of one flattening, which share what is smooth. \return how many were written
int writeAll(const PatternSource& source, FileOptions options, bool lay, const Grading* grading)
{
  int written = 0;
  FairCache fair;
  options.fair = &fair;
  for (const FileFormat format :
    { FileFormat::Svg, FileFormat::Pdf, FileFormat::Dxf, FileFormat::Walk, FileFormat::Hpgl,
      FileFormat::GarmentCode, FileFormat::Nest, FileFormat::GradeList, FileFormat::RuleTable })
  {
    if (format >= FileFormat::Nest && !grading)
    {
      continue;
    }
    SCOPED_TRACE(formatName(format));
    options.format = format;
    options.grading = grading;
    options.fabric.width = lay ? 1500.0 : 0.0;
    Pattern drawing;
    std::string content;
    const Status status = makePatternFile(source, options, drawing, content);
    expectWords(status);
    EXPECT_EQ(status.ok(), !content.empty()) << status.message;
    EXPECT_FALSE(format != FileFormat::Pdf && hasNoNumber(content)) << content.substr(0, 2000);
    written += status.ok() ? 1 : 0;
  }
  return written;
}

/// A case is made from its number alone. \return how many files were written
int tryPieces(unsigned seed)
{
  std::mt19937 random(seed);
  const std::vector<std::uint8_t> bytes = randomBytes(random);
  Bytes reader(bytes);
  const SizeRange sizes{ 1.0, seed % 16 == 0 ? 3000.0 : 120.0 };
  HostileCase input =
    seed % 2 == 0 ? decodeOrdinaryCase(reader, sizes) : decodeCase(reader, dataSpecimens(), sizes);
  const PreparedSurface prepared = prepareSurface(input.points, input.triangles, input.coincident);
  const Execution execution;
  const ImprintedSurface imprinted = prepared.status.ok()
    ? imprintCurves(prepared.mesh, input.polylines, input.imprint, execution)
    : ImprintedSurface();
  if (!prepared.status.ok() || !imprinted.status.ok())
  {
    return 0;
  }
  const FlatteningResult result =
    flattenSurface(imprinted.mesh, imprinted.curves, input.options, execution);
  if (result.status.refused())
  {
    return 0;
  }
  int written = 0;
  for (int k = 0; k < 3; ++k)
  {
    PatternSource source = sourceOf(result);
    const double scale = sizeOf(source.positions);
    if (random() % 4 != 0 && scale > 0.0) // mostly as large as cloth
    {
      const double factor = (20.0 + static_cast<double>(random() % 100)) / scale;
      for (Point2& p : source.positions)
      {
        p *= factor;
      }
      for (Point3& p : source.inSpace)
      {
        p *= factor;
      }
    }
    const PatternSource whole = source;
    const std::string manner = breakPieces(random, source);
    SCOPED_TRACE(input.origin + ", " + manner + ", change " + std::to_string(k));
    const FileOptions options = randomOptions(random, source);
    const bool lay = random() % 3 == 0;
    Grading grading;
    const bool graded = random() % 3 == 0;
    if (graded)
    {
      GradingOptions grades;
      grades.unit = options.pattern.unit;
      expectWords(gradeSizes({ { "S", whole }, { "M", source } }, grades, grading));
    }
    const std::clock_t start = std::clock();
    written += writeAll(source, options, lay, grading.sizes.empty() ? nullptr : &grading);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, secondsEach);
    if (k == 0)
    {
      SewingOptions sewing;
      sewing.maximumIterations = 20;
      sewing.secondStart = false;
      const SewingResult sewn = sewPieces(*result.cut, source.positions, sewing, execution);
      expectWords(sewn.status);
      for (const Point3& p : sewn.points)
      {
        EXPECT_TRUE(p.allFinite());
      }
    }
  }
  return written;
}

/// Runs seeds [first, first + count): HOSTILE_TRACE=1 names each before it is tried.
void trySeeds(unsigned first, unsigned count)
{
#ifdef __linux__
  const rlimit most{ 6UL << 30U, 6UL << 30U }; // what grows without end is to end here
  setrlimit(RLIMIT_AS, &most);
#endif
  ASSERT_GE(dataSpecimens().size(), 15U);
  int written = 0;
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    traceSeed(seed);
    written += tryPieces(seed);
  }
  EXPECT_GT(written, static_cast<int>(count)); // a suite of refusals tests little
}

class BrokenPieces : public testing::TestWithParam<unsigned>
{
};
}

TEST(BrokenFewPieces, AreDrawnOrRefusedInEveryFormat)
{
  trySeeds(0, 24);
}

TEST_P(BrokenPieces, AreDrawnOrRefusedInEveryFormat)
{
  constexpr unsigned count = 40;
  trySeeds(1000 + GetParam() * count, count);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BrokenPieces, testing::Range(0U, 5U));

// Those to try by hand: HOSTILE_SEED=7, HOSTILE_COUNT=1000.
TEST(BrokenPiecesByHand, NamedByTheEnvironmentAreDrawnOrRefused)
{
  trySeeds(fromEnvironment("HOSTILE_SEED", 1), fromEnvironment("HOSTILE_COUNT", 8));
}
