// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Pieces.h"

#include <vtkNew.h>
#include <vtkWireWarpingFilter.h>

#include <string>

namespace editor
{
/// Flattens one surface again and again, with other curves.
class LiveFlattening
{
public:
  LiveFlattening();

  vtkWireWarpingFilter* filter() { return this->Filter; }
  void setSurface(vtkPolyData* surface);
  /// \return whether there is a result; else that of the run before is kept
  bool run(vtkPolyData* curves);

  bool hasResult() const { return this->Result.flat != nullptr; }
  const figures::FlatPiece& result() const { return this->Result; }
  /// What is broken or refused; empty where all is well.
  const std::string& message() const { return this->Message; }
  /// Of the last run.
  double seconds() const { return this->Seconds; }
  /// Whether a run is short enough to go along with the mouse.
  bool isQuick() const { return this->Seconds < 0.040; }

private:
  vtkNew<vtkWireWarpingFilter> Filter;
  figures::FlatPiece Result;
  std::string Message;
  double Seconds = 0.0;
};
}
