// SPDX-License-Identifier: BSD-3-Clause
#include "Check.h"

#include "Base/CompressedRows.h"
#include "BoundaryLoops.h"
#include "FlagWords.h"
#include "Flattening.h"
#include "Input/StatusWords.h"
#include "InputError.h"
#include "Options.h"
#include "OutputFiles.h"
#include "PlainText.h"
#include "ReadSurface.h"
#include "Report/FlatteningData.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/SurfacePreparation.h"
#include "SurfaceMending.h"
#include "TriangleList.h"
#include "Units.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
using Edge = std::pair<std::int64_t, std::int64_t>;

/// What the triangles of a surface form.
struct Shape
{
  std::size_t points = 0;
  std::size_t parts = 0;
  std::size_t handles = 0;
  std::size_t closedParts = 0;
  std::vector<Edge> crowded; ///< edges of more than two triangles
};

Shape shapeOf(const TriangleList& list, const std::vector<BoundaryLoop>& loops)
{
  const std::size_t points = list.points->size();
  flattening::JoinedSets joined(static_cast<flattening::Index>(points));
  const auto partOf = [&joined](std::int64_t point) {
    return joined.find(static_cast<flattening::Index>(point));
  };
  std::map<Edge, int> edges;
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t a = triangle.corners[k];
      const std::int64_t b = triangle.corners[(k + 1) % 3];
      ++edges[std::minmax(a, b)];
      joined.join(partOf(a), partOf(b));
    }
  }
  Shape shape;
  /// Per part points - edges + triangles, and its boundaries.
  std::map<flattening::Index, std::pair<long long, long long>> parts;
  std::vector<bool> counted(points, false);
  for (const auto& [edge, triangles] : edges)
  {
    auto& [euler, boundaries] = parts[partOf(edge.first)];
    --euler;
    for (const std::int64_t point : { edge.first, edge.second })
    {
      euler += counted[point] ? 0 : 1;
      shape.points += counted[point] ? 0 : 1;
      counted[point] = true;
    }
    if (triangles > 2)
    {
      shape.crowded.push_back(edge);
    }
  }
  for (const ListedTriangle& triangle : list.triangles)
  {
    ++parts[partOf(triangle.corners[0])].first;
  }
  for (const BoundaryLoop& loop : loops)
  {
    ++parts[partOf(loop.points.front())].second;
  }
  shape.parts = parts.size();
  for (const auto& [root, counts] : parts)
  {
    shape.closedParts += counts.second == 0 ? 1 : 0;
    shape.handles += static_cast<std::size_t>(
      std::max(0LL, (2 - counts.first - counts.second) / 2)); // 2 - 2 handles - boundaries
  }
  return shape;
}

std::string inShort(double value)
{
  return flattening::shortNumber(value + 0.0); // not -0
}

/// The middle of an opening's bounding box.
std::string placeOf(const BoundaryLoop& loop, const TriangleList& list)
{
  Eigen::AlignedBox3d box;
  for (const std::int64_t point : loop.points)
  {
    box.extend(list.point(point));
  }
  const Point3 middle = box.center();
  return "around " + inShort(middle[0]) + ", " + inShort(middle[1]) + ", " + inShort(middle[2]);
}

void sayUnit(const Options& options, const std::string& stated, const LikelyUnit& likely)
{
  if (stated.empty())
  {
    std::cout << "unit: not stated, " << inShort(likely.size) << ' ' << likely.unit
              << " is likely and taken; state it with --unit " << likely.unit << '\n';
    return;
  }
  std::cout << "unit: " << stated
            << (!options.unit.empty()     ? ", by --unit"
                   : options.height > 0.0 ? ", by --height"
                                          : ", as the file states")
            << '\n';
}

/// Whether it is its own mirror image, as what bodies wear is.
void saySymmetry(const DataSet& data, const TriangleList& list)
{
  const flattening::SurfaceTriangles read = flattening::readTriangles(data);
  const flattening::PreparedSurface surface =
    flattening::prepareSurface(read.points, read.triangles);
  const auto plane = surface.status.ok() ? flattening::findSymmetryPlane(surface.mesh)
                                         : std::optional<flattening::SymmetryPlane>();
  if (!plane)
  {
    std::cout << "symmetry: none is found\n";
    return;
  }
  const double diagonal = boxOf(list).diagonal().norm();
  const double offset = std::abs(plane->offset) < 1e-6 * diagonal ? 0.0 : plane->offset;
  Eigen::Index axis = 0;
  const double along = plane->normal.cwiseAbs().maxCoeff(&axis);
  const double sign = plane->normal[axis] < 0.0 ? -1.0 : 1.0;
  const flattening::Point3 normal = sign * plane->normal;
  const double off = std::round(1e4 * plane->spread) / 100.0; // of 95 % of the surface
  constexpr double nearlyAlong = 0.9998;                      // about one degree
  std::cout << "symmetry: about the plane "
            << (along > nearlyAlong ? std::string(1, "xyz"[axis]) + '=' + inShort(sign * offset)
                                    : "across " + inShort(normal.x()) + ", " + inShort(normal.y()) +
                     ", " + inShort(normal.z()))
            << ", to " << (off < 0.01 ? "less than 0.01" : inShort(off)) << " % of its size"
            << "; cuts come in pairs, except with --symmetric off\n";
}

/// What is of this size, and what `wirewarp make` calls it.
std::pair<std::string, std::string> likelyKind(std::array<double, 3> sides, bool closed)
{
  std::sort(sides.begin(), sides.end());
  const double largest = sides[2];
  return largest > 2500.0 ? std::pair("a tent, a sail or a hull", "tent")
    : closed ? std::pair(largest < 500.0 ? "a toy or a cushion" : "a cover or furniture", "plush")
    : largest > 350.0                    ? std::pair("a garment", "garment")
    : largest > 190.0 && sides[0] > 40.0 ? std::pair("a shoe or a bag", "garment")
                                         : std::pair("a small part", "sheet");
}

/// Whether the surface can be flattened without a cut.
bool canLieFlat(const Shape& shape)
{
  return shape.crowded.empty() && shape.closedParts == 0 && shape.handles == 0;
}

void saySurface(const TriangleList& list, const Shape& shape, const std::string& unit)
{
  const std::vector<BoundaryLoop> loops = openings(list);
  std::cout << "parts: " << shape.parts << ", openings: " << loops.size()
            << ", handles: " << shape.handles << '\n';
  constexpr std::size_t listed = 12;
  for (std::size_t k = 0; k < std::min(loops.size(), listed); ++k)
  {
    std::cout << "opening " << k + 1 << ": " << inShort(loops[k].length) << ' ' << unit << " long, "
              << placeOf(loops[k], list) << '\n';
  }
  std::cout << (loops.size() > listed
      ? "and " + std::to_string(loops.size() - listed) + " shorter openings\n"
      : "");
  if (!shape.crowded.empty())
  {
    std::cout << "defect: " << shape.crowded.size()
              << " edges of more than two triangles, the first between points "
              << shape.crowded.front().first << " and " << shape.crowded.front().second
              << "; remove one of them\n";
  }
  if (shape.closedParts > 0 || shape.handles > 0)
  {
    std::cout << (shape.closedParts > 0 ? "closed" : "it has handles")
              << ": it lies flat with seams alone, which make and cut propose\n";
  }
  else if (loops.size() > shape.parts)
  {
    std::cout << "more openings than parts: holes stay open, a tube needs a seam\n";
  }
}

/// The options that change the surface, for the command that reads it next.
std::string mendingOf(const Options& options)
{
  std::ostringstream words;
  words.precision(12);
  if (!options.weld.empty() && options.weld != "false")
  {
    words << " --weld" << (options.weld == "0" ? "" : " " + options.weld);
  }
  if (options.fillHoles > 0.0)
  {
    words << " --fill-holes " << options.fillHoles;
  }
  words << (options.outerSide == "true" ? " --outer-side" : "");
  if (options.height > 0.0)
  {
    words << " --height " << options.height;
  }
  else if (options.scale != 1.0)
  {
    words << " --scale " << options.scale;
  }
  return words.str();
}
}

int runCheck(const Options& options)
{
  InputFiles inputs;
  inputs.add(options.surface);
  if (!options.surfaceFile.empty())
  {
    inputs.refuseToReplace(std::filesystem::u8path(options.surfaceFile), "--output");
  }
  const SurfaceContents contents = readSurface(options.surface);
  std::string stated = options.unit.empty() ? contents.unit : options.unit;
  if (stated.empty() && options.height > 0.0)
  {
    stated = "mm"; // in which the surface is once it is scaled
  }
  const std::string unit = stated.empty() ? likelyUnit(contents.surface).unit : stated;
  MendedSurface mend = mendedSurface(options, contents, unit);
  if (!contents.note.empty())
  {
    mend.notes.push_back(contents.note);
  }
  TriangleList list = listTriangles(mend.surface);
  if (list.triangles.empty())
  {
    const flattening::SurfaceTriangles read = flattening::readTriangles(mend.surface);
    const flattening::Status status =
      flattening::prepareSurface(read.points, read.triangles).status;
    throw InputError(options.surface, messageOf(status.message, remediesOf(status)));
  }
  if (isScaled(options))
  {
    scaleBy(scaleOf(options, mend.surface, unit), mend.surface);
    list = listTriangles(mend.surface);
  }
  DataSet healed;
  const std::vector<std::string> sentences = flattening::healData(mend.surface, healed);
  if (!sentences.empty())
  {
    mend.notes.insert(mend.notes.end(), sentences.begin(), sentences.end());
    mend.surface = healed;
    list = listTriangles(healed);
  }
  const Point3 sides = boxOf(list).sizes();
  const Shape shape = shapeOf(list, boundaryLoops(list));
  const bool flattens = canLieFlat(shape);
  const Point3 millimetres = sides * millimetresOf(unit);
  const auto likely = likelyKind(
    { millimetres.x(), millimetres.y(), millimetres.z() }, shape.closedParts == shape.parts);
  if (!options.quiet)
  {
    std::cout << plainText(options.surface) << ": " << list.triangles.size() << " triangles, "
              << shape.points << " points\nsize: " << inShort(sides[0]) << " x "
              << inShort(sides[1]) << " x " << inShort(sides[2]) << ' ' << unit << '\n';
    sayUnit(options, stated, likelyUnit(mend.surface));
    saySurface(list, shape, unit);
    saySymmetry(mend.surface, list);
    std::cout << "likely: " << likely.first << ", by its size\n";
  }
  for (const std::string& note : mend.notes)
  {
    std::cerr << messageLine("warning", note);
  }
  if (!options.surfaceFile.empty())
  {
    if (!stated.empty())
    {
      setUnit(mend.surface, stated);
    }
    OutputFiles files;
    files.demandFolder(std::filesystem::u8path(options.surfaceFile).parent_path());
    files.add(std::filesystem::u8path(options.surfaceFile), mend.surface);
    files.publish();
    std::cout << (options.quiet ? "" : "written: " + plainText(options.surfaceFile) + '\n');
  }
  if (shape.crowded.empty() && !options.quiet)
  {
    const bool written = !options.surfaceFile.empty();
    const bool hasUnit = !stated.empty() && (written || options.unit.empty());
    std::cout << "next: wirewarp make "
              << plainText(written ? options.surfaceFile : options.surface)
              << (written ? "" : mendingOf(options)) << (hasUnit ? "" : " --unit " + unit)
              << " --for " << likely.second << '\n';
  }
  return flattens ? Done : Flawed;
}
}
