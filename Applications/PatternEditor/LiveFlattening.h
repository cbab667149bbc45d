// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <vtkNew.h>
#include <vtkWireWarpingFilter.h>

#include <array>
#include <string>

namespace editor
{
/// How well a piece is laid out.
enum class Care
{
  Draft, ///< by the global scheme, which takes a fraction of the time
  Full,
};

/// Flattens one surface again and again, with other curves.
class LiveFlattening
{
public:
  LiveFlattening();

  vtkWireWarpingFilter* filter() { return this->Filter; }
  void setSurface(vtkPolyData* surface);
  /// \return whether there is a result; else that of the run before is kept
  bool run(vtkPolyData* curves, Care care = Care::Full);

  bool hasResult() const { return this->Result.flat != nullptr; }
  const figures::FlatPiece& result() const { return this->Result; }
  /// What is broken or refused; empty where all is well.
  const std::string& message() const { return this->Message; }
  /// Whether the last run with this care was short enough to go along with the mouse.
  bool isQuick(Care care) const { return this->seconds(care) < 0.040; }
  double seconds(Care care) const { return this->Seconds[static_cast<std::size_t>(care)]; }
  /// Of the result.
  Care care() const { return this->ResultCare; }

private:
  vtkNew<vtkWireWarpingFilter> Filter;
  figures::FlatPiece Result;
  std::string Message;
  std::array<double, 2> Seconds{}; ///< of the last run, by care
  Care ResultCare = Care::Full;
};
}
