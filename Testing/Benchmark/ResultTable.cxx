// SPDX-License-Identifier: BSD-3-Clause
#include "ResultTable.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <utility>

namespace benchmarks
{
void ResultTable::printHead()
{
  std::printf("| triangles | method | threads | ms | to CGAL LSCM | to CGAL ARAP | to BFF | wires, "
              "ms | bytes "
              "a triangle | E_len | E_ang | E_h | flips |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void ResultTable::add(Row row)
{
  const auto ratio = [&](const char* peer) {
    const double seconds = this->peerSeconds(peer, row.triangles);
    char text[16];
    std::snprintf(
      text, sizeof text, seconds > 0.0 ? "1/%.1f" : "-", seconds / row.measured.seconds);
    return std::string(text);
  };
  const flattening::QualitySummary quality = row.quality.value_or(flattening::QualitySummary());
  std::printf("| %d | %s | %d | %.4g | %s | %s | %s | %.3g | %.0f | %.2g | %.4f | %.3f | %zu |\n",
    row.triangles, row.method.c_str(), row.threads, 1e3 * row.measured.seconds,
    ratio(conformalPeer).c_str(), ratio(rigidPeer).c_str(), ratio(boundaryFirstPeer).c_str(),
    1e3 * row.wires, row.measured.peakBytes / row.triangles, quality.edgeLengthError,
    quality.angleError, quality.globalHomogeneity, quality.flipped.size());
  std::fflush(stdout);
  this->Rows.push_back(std::move(row));
}

double ResultTable::peerSeconds(const char* method, flattening::Index triangles) const
{
  for (const Row& row : this->Rows)
  {
    if (row.method == method && row.triangles == triangles)
    {
      return row.measured.seconds;
    }
  }
  return 0.0;
}

void ResultTable::write(const std::string& path, const std::string& piece) const
{
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const Row& row : this->Rows)
  {
    Json entry = { { "triangles", row.triangles }, { "method", row.method },
      { "threads", row.threads }, { "seconds", row.measured.seconds },
      { "processor_seconds", row.measured.processor }, { "runs", row.measured.runs } };
    if (row.quality)
    {
      entry.update({ { "seconds_wires", row.wires },
        { "bytes_a_triangle", row.measured.peakBytes / row.triangles },
        { "E_len", row.quality->edgeLengthError }, { "E_ang", row.quality->angleError },
        { "E_h", row.quality->globalHomogeneity }, { "flips", row.quality->flipped.size() } });
    }
    rows.push_back(std::move(entry));
  }
  const Json all = { { "piece", piece }, { "rows", rows } };
  writeFile(path, all.dump(2) + '\n');
}
}
