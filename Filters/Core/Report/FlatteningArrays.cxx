// SPDX-License-Identifier: BSD-3-Clause
#include "Report/FlatteningArrays.h"

#include "Base/Types.h"
#include "Cut/SurfaceCut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace flattening
{
namespace
{
/// The largest strain of a triangle and its direction: warp, weft, or the bias between them, in
/// which a shear of g draws by about g / 2.
struct Dominant
{
  unsigned char thread = 0;
  double strain = 0.0;
};

Dominant dominantOf(const ThreadStrain& strain)
{
  const double bias = 0.5 * (strain.warp + strain.weft) + std::sin(0.5 * std::abs(strain.shear));
  Dominant dominant{ 0, strain.warp };
  const auto consider = [&dominant](unsigned char thread, double value) {
    if (std::abs(value) > std::abs(dominant.strain))
    {
      dominant = { thread, value };
    }
  };
  consider(1, strain.weft);
  consider(2, bias);
  return dominant;
}

/// The cell arrays of threads; none where there is no material.
void addThreads(const FlatteningResult& result, Columns& cells)
{
  const std::vector<ThreadStrain>& threads = result.threads;
  if (threads.empty())
  {
    return;
  }
  const TableColumns<ThreadStrain> columns(cells, threads);
  using Strain = const ThreadStrain&;
  columns.add("StrainWarp", &ThreadStrain::warp);
  columns.add("StrainWeft", &ThreadStrain::weft);
  columns.add("ShearAngle", [](Strain strain) { return strain.shear / degree; });
  std::vector<unsigned char> out(threads.size(), 0);
  for (const PieceReport& piece : result.pieces)
  {
    for (Index t : piece.cloth ? piece.cloth->outOfLimit : Indices())
    {
      out[t] = 1;
    }
  }
  cells.push_back({ "OutOfLimit", std::move(out) });
  columns.addAs<unsigned char>(
    "DominantThread", [](Strain strain) { return dominantOf(strain).thread; });
  columns.add(
    "DominantStretch", [](Strain strain) { return 100.0 * (1.0 + dominantOf(strain).strain); });
}

/// `GrainAngle` of each piece, by which patterns know that pieces lie on a material.
void addGrain(const FlatteningResult& result, Columns& field)
{
  // Without a material what the field data of the input had is removed: patterns of it would lie on
  // a cloth.
  const std::size_t rows = result.threads.empty() ? 0 : result.pieces.size();
  addRows<double>(field, "GrainAngle", rows, [&](std::size_t row) {
    const auto& cloth = result.pieces[row].cloth;
    return cloth ? cloth->grain.angle / degree : 0.0;
  });
}

void addOverlapEdges(const FlatteningResult& result, Columns& field)
{
  std::vector<std::int64_t> edges;
  const TriangleMesh& mesh = result.cut->mesh;
  for (std::size_t p = 0; p < result.pieces.size(); ++p)
  {
    for (const std::array<Index, 2>& pair : result.pieces[p].overlaps.listed)
    {
      edges.insert(edges.end(),
        { mesh.from(pair[0]), mesh.to(pair[0]), mesh.from(pair[1]), mesh.to(pair[1]),
          static_cast<Index>(p) });
    }
  }
  field.push_back({ "OverlapEdges", std::move(edges), 5 });
}

/// Per wire-patch its place in the order in which its piece was warped.
Indices placesInOrder(const FlatteningResult& result)
{
  Indices place;
  for (const PieceReport& piece : result.pieces)
  {
    for (std::size_t i = 0; i < piece.warpingOrder.size(); ++i)
    {
      const std::size_t patch = static_cast<std::size_t>(piece.warpingOrder[i]);
      place.resize(std::max(place.size(), patch + 1), none);
      place[patch] = static_cast<Index>(i);
    }
  }
  return place;
}

void addPatches(const FlatteningResult& result, Columns& cells)
{
  const Indices& patches = result.patchOfTriangle;
  cells.push_back({ "WirePatchId", std::vector<std::int64_t>(patches.begin(), patches.end()) });
  const Indices place = placesInOrder(result);
  if (!place.empty())
  {
    addRows<std::int64_t>(cells, "WarpingOrder", patches.size(), [&](std::size_t t) {
      const std::size_t patch = static_cast<std::size_t>(patches[t]);
      return patch < place.size() ? place[patch] : none;
    });
  }
}

/// One number that colors wires: the type of the curve, -1 for the boundary, -2 for connectors.
int kindOf(const Wire& wire)
{
  return wire.connector ? -2 : wire.curve == none ? -1 : static_cast<int>(wire.type);
}

void addFlatLengths(const std::vector<Wire>& wires, Columns& cells)
{
  const TableColumns<Wire> columns(cells, wires);
  columns.addAs<int>("WireKind", kindOf);
  columns.addAs<unsigned char>("Connector", &Wire::connector);
  columns.add("FlatLength", &Wire::flatLength);
  columns.add("LengthError", &Wire::maximumEdgeError);
}

/// Per row of SeamPairs whether the two edges lie on each other because their cut was closed.
void addClosedSeams(const FlatteningResult& result, Columns& field)
{
  std::vector<char> closed(result.cut->mesh.halfedgeCount(), 0);
  for (const PieceReport& piece : result.pieces)
  {
    for (Index h : piece.closedEdges)
    {
      closed[h] = 1;
    }
  }
  const std::vector<SeamPair>& pairs = result.cut->seamPairs;
  addRows<unsigned char>(field, "SeamClosed", pairs.size(),
    [&](std::size_t i) { return static_cast<unsigned char>(closed[pairs[i].first]); });
}

/// The vertices that points of the input which healing joined to another are at, and these points.
std::vector<std::pair<Index, std::int64_t>> joinedPoints(
  const CurvedSurface& source, const CutSurface& cut)
{
  const HealedSurface& healed = source.surface.prepared;
  std::multimap<std::int64_t, std::int64_t> joinedTo;
  for (const Index p : healed.joinedPoints)
  {
    const Index vertex = healed.vertexOfPoint[p];
    if (vertex != none)
    {
      joinedTo.emplace(healed.originalPoint[vertex], p);
    }
  }
  std::vector<std::pair<Index, std::int64_t>> joined;
  const std::size_t count = joinedTo.empty() ? 0 : cut.originalVertex.size();
  for (std::size_t v = 0; v < count; ++v)
  {
    const auto points = joinedTo.equal_range(source.pointOf(cut.originalVertex[v]));
    for (auto point = points.first; point != points.second; ++point)
    {
      joined.emplace_back(static_cast<Index>(v), point->second);
    }
  }
  return joined;
}
}

CutArrays cutArrays(const CurvedSurface& source, const CutSurface& cut)
{
  CutArrays arrays;
  arrays.originalVertex = cut.originalVertex;
  arrays.points = cut.mesh.points();
  addRows<std::int64_t>(arrays.pointArrays, "vtkOriginalPointIds", cut.originalVertex.size(),
    [&](std::size_t v) { return source.pointOf(cut.originalVertex[v]); });
  const std::size_t count = cut.pieceOfTriangle.size();
  addRows<std::int64_t>(arrays.cellArrays, "vtkOriginalCellIds", count,
    [&](std::size_t t) { return source.cellOf(cut.originalTriangle(static_cast<Index>(t))); });
  arrays.cellArrays.push_back({ "PieceId",
    std::vector<std::int64_t>(cut.pieceOfTriangle.begin(), cut.pieceOfTriangle.end()) });
  return arrays;
}

Column seamPairs(const CutSurface& cut)
{
  std::vector<std::int64_t> pairs;
  for (const SeamPair& pair : cut.seamPairs)
  {
    // The second half-edge runs against the first.
    pairs.insert(pairs.end(),
      { cut.mesh.from(pair.first), cut.mesh.to(pair.first), cut.mesh.to(pair.second),
        cut.mesh.from(pair.second), pair.curve });
  }
  return { "SeamPairs", std::move(pairs), 5 };
}

void addTriangleQuality(const std::vector<TriangleQuality>& quality, Columns& cells)
{
  const TableColumns<TriangleQuality> columns(cells, quality);
  columns.add("HomogeneityOfDistortion", &TriangleQuality::homogeneity);
  columns.add("AspectRatio", &TriangleQuality::aspectRatio);
  columns.add("AreaRatio", &TriangleQuality::areaRatio);
  columns.add("AngleError", &TriangleQuality::angleError);
  columns.addAs<unsigned char>(
    "Flipped", [](const TriangleQuality& triangle) { return triangle.areaRatio <= 0.0; });
}

Columns wireArrays(const std::vector<Wire>& wires, const std::vector<FeatureCurve>& curves)
{
  Columns cells;
  const TableColumns<Wire> columns(cells, wires);
  columns.addAs<int>("CurveType",
    [](const Wire& wire) { return wire.curve == none ? -1 : static_cast<int>(wire.type); });
  columns.add("CurveId", &Wire::curve);
  columns.add("CurveName", [&curves](const Wire& wire) {
    return wire.curve != none ? curves[wire.curve].name
      : wire.connector        ? std::string("connector")
                              : std::string("boundary");
  });
  columns.add("PieceId", &Wire::piece);
  columns.addAs<unsigned char>("Boundary", &Wire::boundary);
  columns.add("RestLength", &Wire::restLength);
  return cells;
}

FlatteningArrays flatteningArrays(
  const CurvedSurface& source, const FlatteningResult& result, const FlatteningOptions& options)
{
  FlatteningArrays arrays;
  static_cast<CutArrays&>(arrays) = cutArrays(source, *result.cut);
  arrays.pointArrays.push_back({ "Developability", result.developability });
  arrays.positions = result.positions;
  auto& ids = std::get<std::vector<std::int64_t>>(arrays.pointArrays[0].values);
  auto& developability = std::get<std::vector<double>>(arrays.pointArrays[1].values);
  for (const auto& [vertex, point] : joinedPoints(source, *result.cut))
  {
    arrays.originalVertex.push_back(arrays.originalVertex[vertex]);
    arrays.points.push_back(arrays.points[vertex]);
    arrays.positions.push_back(arrays.positions[vertex]);
    ids.push_back(point);
    developability.push_back(developability[vertex]);
  }
  addTriangleQuality(result.triangles, arrays.cellArrays);
  addPatches(result, arrays.cellArrays);
  addThreads(result, arrays.cellArrays);

  arrays.wireArrays = wireArrays(result.wires, source.imprinted.curves);
  addFlatLengths(result.wires, arrays.wireArrays);

  addGrain(result, arrays.fieldArrays);
  arrays.fieldArrays.push_back(seamPairs(*result.cut));
  addClosedSeams(result, arrays.fieldArrays);
  addOverlapEdges(result, arrays.fieldArrays);
  const bool sheet = options.cloth && options.cloth->material.sheet;
  arrays.fieldArrays.push_back({ "SheetMaterial", std::vector<int>(sheet ? 1 : 0, 1) });
  return arrays;
}

std::string describeLeftOut(const CurvedSurface& source, const FlatteningResult& result)
{
  Indices closed;
  Indices handled;
  for (const PieceDefect& defect : result.leftOut)
  {
    const auto cell = static_cast<Index>(source.cellOf(defect.triangle));
    (defect.closed ? closed : handled).push_back(cell);
  }
  std::string text = std::to_string(result.leftOut.size()) + " of " +
    std::to_string(result.leftOut.size() + result.pieces.size()) +
    " pieces cannot be laid flat and were left out:";
  if (!closed.empty())
  {
    text += " without boundary those of cells " + listIds(closed);
  }
  if (!handled.empty())
  {
    text +=
      std::string(closed.empty() ? "" : ",") + " with handles those of cells " + listIds(handled);
  }
  return text;
}
}
