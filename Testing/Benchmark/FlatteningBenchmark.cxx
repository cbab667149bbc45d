// SPDX-License-Identifier: BSD-3-Clause
// The whole flattening of a trouser leg of 2 thousand to 2 million triangles beside CGAL's
// parameterizations, which keep no length, in one run. Prints tables in Markdown.
#include "Measure.h"
#include "Peer.h"
#include "RefinedPiece.h"

#include "Base/Execution.h"
#include "Flattening/SurfaceFlattening.h"
#include "Quality/FlatteningQuality.h"
#include "Wires/WireNetwork.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using namespace benchmarks;
using namespace flattening;

struct Settings
{
  std::string folder;
  std::string piece = "pants_front";
  std::vector<int> divisions{ 1, 4, 11, 34 };
  std::vector<int> threads{ 2 };
  Repeats repeats;
  int peersUntil = 300000;
  std::string boundaryFirst;
  std::string json;
};

struct Method
{
  const char* name;
  Scheme scheme;
  InteriorMethod interior;
};

const std::vector<Method> methods{
  { "laplacian", Scheme::Global, InteriorMethod::Laplacian },
  { "rigid", Scheme::Global, InteriorMethod::AsRigidAsPossible },
  { "isometric", Scheme::Isometric, InteriorMethod::AsRigidAsPossible },
};

/// One method on one mesh.
struct Row
{
  std::string method;
  int threads = 1;
  Index triangles = 0;
  Measured measured;
  double wires = 0.0;                    ///< seconds of the wires alone
  std::optional<QualitySummary> quality; ///< nothing where only time is known
};

/// What a run measured, in Markdown while it goes on and as JSON at its end.
class ResultTable
{
public:
  ResultTable()
  {
    std::printf(
      "| triangles | method | threads | ms | wires, ms | bytes a triangle | E_len | E_ang "
      "| E_h | flips |\n|---|---|---|---|---|---|---|---|---|---|\n");
  }
  void add(const Row& row)
  {
    const QualitySummary quality = row.quality.value_or(QualitySummary());
    std::printf("| %d | %s | %d | %.4g | %.3g | %.0f | %.2g | %.4f | %.3f | %zu |\n", row.triangles,
      row.method.c_str(), row.threads, 1e3 * row.measured.seconds, 1e3 * row.wires,
      row.measured.peakBytes / row.triangles, quality.edgeLengthError, quality.angleError,
      quality.globalHomogeneity, quality.flipped.size());
    std::fflush(stdout);
    nlohmann::ordered_json entry = { { "triangles", row.triangles }, { "method", row.method },
      { "threads", row.threads }, { "seconds", row.measured.seconds },
      { "processor_seconds", row.measured.processor }, { "runs", row.measured.runs } };
    if (row.quality)
    {
      entry.update({ { "seconds_wires", row.wires },
        { "bytes_a_triangle", row.measured.peakBytes / row.triangles },
        { "E_len", quality.edgeLengthError }, { "E_ang", quality.angleError },
        { "E_h", quality.globalHomogeneity }, { "flips", quality.flipped.size() } });
    }
    this->Rows.push_back(std::move(entry));
  }
  /// Throws std::runtime_error where the file cannot be written.
  void write(const std::string& path, const std::string& piece) const
  {
    const nlohmann::ordered_json all = { { "piece", piece }, { "rows", this->Rows } };
    writeFile(path, all.dump(2) + '\n');
  }

private:
  nlohmann::ordered_json Rows = nlohmann::ordered_json::array();
};

Row runMethod(
  const RefinedPiece& piece, const Method& method, int threads, const Settings& settings)
{
  FlatteningOptions options;
  options.scheme = method.scheme;
  options.interior.method = method.interior;
  options.releaseKeys = true;
  const Execution execution = threadedExecution(threads);
  Row row;
  row.method = method.name;
  row.threads = threads;
  row.triangles = piece.mesh.triangleCount();
  row.measured = measure(settings.repeats, [&] {
    const FlatteningResult result = flattenSurface(piece.mesh, piece.curves, options, execution);
    if (result.status.refused())
    {
      throw std::runtime_error(result.status.message);
    }
    row.wires = result.seconds.wires;
    row.quality = result.pieces.front().quality;
    return result.seconds.total - result.seconds.quality;
  });
  return row;
}

/// Of the largest, cut piece, its scale chosen by the perimeter.
Row runPeer(const RefinedPiece& piece, const char* name,
  PeerResult (*peer)(const TriangleMesh& mesh), const Settings& settings)
{
  const CutSurface cut = cutSurface(piece.mesh, piece.curves);
  const Piece disk = extractPieces(cut).front();
  const WireNetwork network = buildWireNetwork(disk);
  Indices wires;
  for (const WireEdge& edge : network.edges)
  {
    wires.push_back(network.halfedge[edge.side]);
  }
  Row row;
  row.method = name;
  row.triangles = piece.mesh.triangleCount();
  PeerResult result;
  row.measured = measure(settings.repeats, [&] {
    result = peer(disk.mesh);
    return result.seconds;
  });
  double perimeter = 0.0;
  double flat = 0.0;
  double area = 0.0;
  for (Index h = 0; h < disk.mesh.halfedgeCount(); ++h)
  {
    const Point2& from = result.positions[disk.mesh.from(h)];
    const Point2& to = result.positions[disk.mesh.to(h)];
    if (disk.mesh.twin(h) == none)
    {
      perimeter += disk.mesh.length(h);
      flat += (to - from).norm();
      area += from.x() * to.y() - from.y() * to.x();
    }
  }
  for (Point2& p : result.positions)
  {
    p *= perimeter / flat;
    p.y() *= area < 0.0 ? -1.0 : 1.0;
  }
  row.quality = measureFlattening(disk.mesh, result.positions, wires, {}).summary;
  return row;
}

void run(const Settings& settings, int division, ResultTable& table)
{
  const RefinedPiece piece = readRefined(settings.folder, settings.piece, division);
  if (piece.mesh.triangleCount() <= settings.peersUntil)
  {
    table.add(runPeer(piece, "CGAL LSCM", runConformalPeer, settings));
    table.add(runPeer(piece, "CGAL ARAP", runRigidPeer, settings));
  }
  if (!settings.boundaryFirst.empty())
  {
    Row row;
    row.method = "BFF";
    row.triangles = piece.mesh.triangleCount();
    row.measured = runProgram(settings.boundaryFirst,
      extractPieces(cutSurface(piece.mesh, piece.curves)).front().mesh, settings.repeats);
    table.add(row);
  }
  for (const Method& method : methods)
  {
    for (const int threads : settings.threads)
    {
      table.add(runMethod(piece, method, threads, settings));
    }
  }
}
}

int main(int argc, char** argv)
{
  Settings settings;
  CLI::App app("Whole flattening beside CGAL's parameterizations");
  app.add_option("DATA", settings.folder, "Folder of the pieces")->required();
  app.add_option("--piece", settings.piece, "Name of the piece")->capture_default_str();
  app.add_option("--divisions", settings.divisions, "Parts of each edge")->capture_default_str();
  app.add_option("--threads", settings.threads, "Numbers of threads, each measured")
    ->capture_default_str();
  app.add_option("--repeats", settings.repeats.most, "Runs, of which the median counts")
    ->capture_default_str();
  app
    .add_option("--seconds", settings.repeats.seconds,
      "No further run of a method once its runs have taken so long")
    ->capture_default_str();
  app.add_option("--peers-until", settings.peersUntil, "Most triangles for CGAL")
    ->capture_default_str();
  app.add_option("--bff", settings.boundaryFirst,
    "Program of your own for boundary first flattening: FILE.obj RUNS, prints seconds and "
    "processor seconds of each run");
  app.add_option("--json", settings.json, "File for the table");
  CLI11_PARSE(app, argc, argv);
  ResultTable table;
  try
  {
    for (const int division : settings.divisions)
    {
      run(settings, division, table);
      if (!settings.json.empty()) // after each size, lest a long run be lost
      {
        table.write(settings.json, settings.piece);
      }
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "FlatteningBenchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
