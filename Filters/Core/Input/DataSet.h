// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/Columns.h"
#include "Input/CurvedSurface.h"
#include "Input/InputSurface.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace flattening
{
/// Cells as lists of point ids.
struct CellList
{
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int64_t> ids; ///< of all cells, one after the other

  std::size_t size() const { return this->offsets.size() - 1; }
  const std::int64_t* begin(std::size_t cell) const
  {
    return this->ids.data() + this->offsets[cell];
  }
  const std::int64_t* end(std::size_t cell) const
  {
    return this->ids.data() + this->offsets[cell + 1];
  }
  template <class Ids>
  void add(const Ids& cell)
  {
    this->ids.insert(this->ids.end(), cell.begin(), cell.end());
    this->offsets.push_back(static_cast<std::int64_t>(this->ids.size()));
  }
  bool operator==(const CellList& other) const
  {
    return this->offsets == other.offsets && this->ids == other.ids;
  }
};

/// Points with polylines, polygons and strips of triangles and their arrays, as files and front
/// ends have them. Cells are numbered through in this order, behind those that are points.
struct DataSet
{
  /// Never null. Data sets that share it are of the same points.
  std::shared_ptr<const Points3> points = std::make_shared<const Points3>();
  std::size_t vertexCells = 0;
  CellList lines;
  CellList faces;
  CellList strips;
  Columns pointArrays;
  Columns cellArrays;
  Columns fieldArrays; ///< lists of any length

  std::size_t cells() const
  {
    return this->vertexCells + this->lines.size() + this->faces.size() + this->strips.size();
  }
  std::size_t firstFace() const { return this->vertexCells + this->lines.size(); }
};

/// Which cells that the cell array `vtkGhostType` marks are read.
enum class GhostCells
{
  LeftOut,    ///< neither hidden ones nor copies of other processes' cells
  Duplicates, ///< also those copies, for what is computed around a point
};

/// Whether a cell of the data is to be read.
class CellChoice
{
public:
  explicit CellChoice(const DataSet& data, GhostCells ghosts = GhostCells::LeftOut);
  bool reads(std::size_t cell) const;

private:
  const Column* Ghosts;
  int LeftOut;
};

/// The polygons and strips, but ghost cells, divided into triangles.
SurfaceTriangles readTriangles(const DataSet& surface, GhostCells ghosts = GhostCells::LeftOut);

/// Adds the line cells of a data set, but ghost cells; the arrays are those of
/// vtkFeatureCurveAlgorithm. The outcome says whether all of them are sound.
void readCurves(const DataSet& data, int source, CurveInput& curves);

/// A text without the character NUL, which ends texts in VTK's files, so that readers crash on what
/// is behind it: "\0" stands for it.
std::string withoutNul(std::string text);

/// The arrays of the input at vertices of the imprinted surface: copies of its points' values, and
/// means of them at points that imprinting made.
Columns arraysOfVertices(
  const Columns& pointArrays, const CurvedSurface& source, const Indices& vertices);
}
