// SPDX-License-Identifier: BSD-3-Clause
#include "Report/SewingReport.h"

#include "Base/Types.h"

#include <array>
#include <cstddef>
#include <utility>

namespace flattening
{
namespace
{
Status invalid(std::size_t row, const std::string& defect)
{
  return invalidOption("row " + std::to_string(row) + " of SeamPairs " + defect,
    "the flat pieces as they came out of the flattening");
}

/// Finds the two half-edges of a row: from a to b and from d to c, or both the other way round.
bool findPair(const TriangleMesh& mesh, const std::array<Index, 4>& v, SeamPair& pair)
{
  pair.first = mesh.find(v[0], v[1]);
  pair.second = mesh.find(v[3], v[2]);
  if (pair.first == none || pair.second == none)
  {
    pair.first = mesh.find(v[1], v[0]);
    pair.second = mesh.find(v[2], v[3]);
  }
  return pair.first != none && pair.second != none && pair.first != pair.second &&
    mesh.twin(pair.first) == none && mesh.twin(pair.second) == none;
}

Status readSeams(const Column& pairs, const Indices& vertexOfPoint, CutSurface& cut)
{
  if (pairs.components < 4)
  {
    return invalid(0, "has fewer than 4 components");
  }
  std::vector<char> sewn(cut.mesh.halfedgeCount(), 0);
  for (std::size_t row = 0; row < pairs.rows(); ++row)
  {
    std::array<Index, 4> vertices{};
    for (int k = 0; k < 4; ++k)
    {
      const double id = pairs.number(row, k);
      if (!(id >= 0.0 && id < static_cast<double>(vertexOfPoint.size())) ||
        vertexOfPoint[static_cast<std::size_t>(id)] == none)
      {
        return invalid(row, "uses a point that is not there");
      }
      vertices[static_cast<std::size_t>(k)] = vertexOfPoint[static_cast<std::size_t>(id)];
    }
    SeamPair pair;
    if (!findPair(cut.mesh, vertices, pair))
    {
      return invalid(row, "is not two edges on the boundaries of pieces");
    }
    if (sewn[pair.first] || sewn[pair.second])
    {
      return invalid(row, "sews an edge that another row sews");
    }
    sewn[pair.first] = sewn[pair.second] = 1;
    if (pairs.components > 4)
    {
      pair.curve = static_cast<Index>(pairs.number(row, 4));
    }
    cut.seamPairs.push_back(pair);
  }
  return {};
}

Column distances(const Indices& vertexOfPoint, const std::vector<double>& ofVertex)
{
  Columns columns;
  addRows<double>(columns, "Distance", vertexOfPoint.size(), [&](std::size_t point) {
    const Index vertex = vertexOfPoint[point];
    return vertex == none ? 0.0 : ofVertex[vertex];
  });
  return columns.front();
}

Columns cellArrays(const SewingResult& result)
{
  Columns cells;
  const Indices& shapes = result.shapeOfTriangle;
  cells.push_back({ "ShapeId", std::vector<std::int64_t>(shapes.begin(), shapes.end()) });
  cells.push_back({ "NormalDeviation", result.normalDeviation });
  addRows<double>(cells, "PrincipalStrains", 2 * shapes.size(),
    [&](std::size_t k) { return result.stretches[k / 2][k % 2] - 1.0; });
  cells.back().components = 2;
  TableColumns(cells, result.stretches).addAs<unsigned char>("Compressed", isCompressed);
  if (!result.threads.empty())
  {
    const TableColumns columns(cells, result.threads);
    columns.add("SewnStrainWarp", &ThreadStrain::warp);
    columns.add("SewnStrainWeft", &ThreadStrain::weft);
    columns.add("SewnShearAngle", [](const ThreadStrain& strain) { return strain.shear / degree; });
  }
  return cells;
}

Columns shapeTable(const std::vector<SewnReport>& shapes)
{
  Columns table;
  const TableColumns<SewnReport> columns(table, shapes);
  using Shape = const SewnReport&;
  const auto measure = [&columns](const char* name, double SewnMeasures::*member) {
    columns.add(name, [member](Shape shape) { return shape.measures.*member; });
  };
  const auto share = [&columns](const char* name, double SewnMeasures::*member) {
    columns.add(name, [member](Shape shape) {
      return shape.measures.size > 0.0 ? shape.measures.*member / shape.measures.size : 0.0;
    });
  };
  columns.addNumbers("Shape");
  columns.add("Status", [](Shape shape) { return statusName(shape.status.code); });
  columns.add("Pieces", &SewnReport::pieces);
  measure("Size", &SewnMeasures::size);
  measure("DistanceMean", &SewnMeasures::distanceMean);
  measure("DistanceRms", &SewnMeasures::distanceRms);
  measure("DistanceP95", &SewnMeasures::distanceP95);
  measure("DistanceMax", &SewnMeasures::distanceMax);
  share("RelativeDistanceMean", &SewnMeasures::distanceMean);
  share("RelativeDistanceRms", &SewnMeasures::distanceRms);
  share("RelativeDistanceP95", &SewnMeasures::distanceP95);
  share("RelativeDistanceMax", &SewnMeasures::distanceMax);
  measure("NormalDeviationMean", &SewnMeasures::normalDeviationMean);
  measure("StrainMean", &SewnMeasures::strainMean);
  measure("StrainP95", &SewnMeasures::strainP95);
  measure("StrainMax", &SewnMeasures::strainMax);
  measure("CompressedArea", &SewnMeasures::compressedArea);
  if (!shapes.empty() && shapes.front().threads)
  {
    columns.add("StrainWarpRms", [](Shape shape) { return shape.threads->summary.warpRms; });
    columns.add("StrainWeftRms", [](Shape shape) { return shape.threads->summary.weftRms; });
    columns.add("ShearRms", [](Shape shape) { return shape.threads->summary.shearRms / degree; });
  }
  columns.add("BodyDepth", &SewnReport::bodyDepth);
  columns.add("SecondDistanceMean", &SewnReport::secondDistance);
  columns.add("SeveralShapes", &SewnReport::severalShapes);
  columns.add("MembraneEnergy", &SewnReport::membraneEnergy);
  columns.add("BendingEnergy", &SewnReport::bendingEnergy);
  columns.add("Triangles", &SewnReport::triangles);
  columns.add("Iterations", &SewnReport::iterations);
  columns.add("Converged", &SewnReport::converged);
  columns.add("StatusMessage", [](Shape shape) { return shape.status.message; });
  return table;
}

Columns seamArrays(const SewnInput& input, const SewingResult& result)
{
  const TriangleMesh& mesh = input.cut.mesh;
  const Indices& pointOf = input.map.surface.prepared.originalPoint;
  std::vector<std::int64_t> pairs;
  std::vector<double> strains;
  for (std::size_t k = 0; k < input.cut.seamPairs.size(); ++k)
  {
    const SeamPair& pair = input.cut.seamPairs[k];
    pairs.insert(pairs.end(),
      { pointOf[mesh.from(pair.first)], pointOf[mesh.to(pair.first)], pointOf[mesh.to(pair.second)],
        pointOf[mesh.from(pair.second)], pair.curve });
    strains.insert(strains.end(), result.seamStrain[k].begin(), result.seamStrain[k].end());
  }
  return { { "SeamPairs", std::move(pairs), 5 }, { "SeamStrains", std::move(strains), 2 } };
}

/// Sentences on shapes that are not the only ones, or not where they should be.
void describeShapes(const std::vector<SewnReport>& shapes, std::vector<std::string>& warnings)
{
  for (std::size_t s = 0; s < shapes.size(); ++s)
  {
    const SewnReport& shape = shapes[s];
    const std::string cloth =
      shapes.size() == 1 ? "the cloth" : "the cloth of ShapeId " + std::to_string(s);
    if (shape.severalShapes)
    {
      warnings.push_back(cloth +
        " buckles and has several shapes at rest: from a second start it lies " +
        shortNumber(shape.secondDistance) + " from the design in the mean, not " +
        shortNumber(shape.measures.distanceMean));
    }
    if (shape.bodyDepth > 0.0)
    {
      warnings.push_back(cloth + " lies " + shortNumber(shape.bodyDepth) +
        " deep in the body; see that the body's normals point outwards and the design is not "
        "inside");
    }
  }
}

/// One row per iteration.
Columns sewingIterations(const SewingResult& result)
{
  Columns table;
  const auto rows = numberedElements(result.shapes, &SewnReport::history);
  const TableColumns columns(table, rows);
  columns.add("Shape", [](const auto& row) { return row.first; });
  columns.add("Energy", [](const auto& row) { return row.second.energy; });
  columns.add("Force", [](const auto& row) { return row.second.force; });
  columns.add("Move", [](const auto& row) { return row.second.move; });
  return table;
}

}

SewnInput makeSewnInput(MappedSurface map, const Column* seams)
{
  SewnInput result;
  result.map = std::move(map);
  result.outcome = result.map.outcome;
  if (result.outcome.ok())
  {
    // Without curves this finds the pieces and leaves vertices and triangles as they are.
    result.cut = cutSurface(result.map.surface.prepared.mesh, {});
    result.outcome = result.cut.status;
  }
  if (result.outcome.ok() && seams)
  {
    result.outcome = readSeams(*seams, result.map.surface.prepared.vertexOfPoint, result.cut);
  }
  return result;
}

SewnArrays sewnArrays(const Points3& design, const SewnInput& input, const SewingResult& result)
{
  const HealedSurface& prepared = input.map.surface.prepared;
  SewnArrays arrays;
  arrays.points = design;
  for (std::size_t v = 0; v < result.points.size(); ++v)
  {
    arrays.points[static_cast<std::size_t>(prepared.originalPoint[v])] = result.points[v];
  }
  arrays.distance = distances(prepared.vertexOfPoint, result.distance);
  arrays.designDistance = distances(prepared.vertexOfPoint, result.designDistance);
  arrays.cellArrays = cellArrays(result);
  arrays.fieldArrays = seamArrays(input, result);
  arrays.shapes = shapeTable(result.shapes);
  arrays.iterations = sewingIterations(result);
  describeShapes(result.shapes, arrays.warnings);
  return arrays;
}
}
