// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Measure.h"
#include "Quality/FlatteningQuality.h"

#include <optional>
#include <string>
#include <vector>

namespace benchmarks
{
/// One method on one mesh.
struct Row
{
  std::string method;
  int threads = 1;
  flattening::Index triangles = 0;
  Measured measured;
  double wires = 0.0;                                ///< seconds of the wires alone
  std::optional<flattening::QualitySummary> quality; ///< nothing where only time is known
};

/// What a run measured, in Markdown while it goes on and as JSON at its end.
class ResultTable
{
public:
  static constexpr const char* conformalPeer = "CGAL LSCM";
  static constexpr const char* rigidPeer = "CGAL ARAP";
  static constexpr const char* boundaryFirstPeer = "BFF";

  static void printHead();
  void add(Row row);
  /// Throws std::runtime_error where the file cannot be written.
  void write(const std::string& path, const std::string& piece) const;

private:
  double peerSeconds(const char* method, flattening::Index triangles) const;

  std::vector<Row> Rows;
};
}
