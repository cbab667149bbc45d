// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveList.h"

#include <array>
#include <string>
#include <vector>

namespace wirewarp
{
/// What a file says of the faces of a surface beside their corners; a list that is empty says
/// nothing.
struct FaceLabels
{
  /// Names by their numbers; the number 0 is of faces without one.
  std::vector<std::string> names{ {} };
  /// By face, numbers of the names of its object, group and material.
  std::vector<std::size_t> objects;
  std::vector<std::size_t> groups;
  std::vector<std::size_t> materials;
  /// Texture coordinates, and which of them each corner of each face has, from 1; 0: none.
  std::vector<std::array<double, 2>> textures;
  std::vector<std::size_t> corners;
};

/// What a file holds of a surface.
struct SurfaceContents
{
  DataSet surface;        ///< of .vtp and .vtk with the polylines among its cells
  DataSet curves;         ///< of .obj, over the same points
  std::string unit = {};  ///< that the file states, as in Units.h; empty: none
  FaceLabels labels = {}; ///< of the faces of .obj
  bool doubled = false;   ///< the format doubles points along texture seams, which are to be joined
  std::string note = {};  ///< what is left out of a file; empty where nothing is
};

enum class SeamSource
{
  None,
  Textures,  ///< edges along which texture coordinates break
  Materials, ///< edges between faces of two materials
  Groups,    ///< edges between faces of two objects or groups
};

/// The names of pieces that the faces have: of their objects, where there are two at least, else of
/// their groups; an empty list where neither tells faces apart.
std::vector<std::string> pieceNames(const FaceLabels& labels);

/// Seams (CurveType 3) along all such edges within the surface, from one junction or end to the
/// next, over its points. The work grows with the number of faces. Without lines where there is no
/// such edge. Throws InputError where the file says nothing of the kind.
DataSet seamsOf(const DataSet& surface, const FaceLabels& labels, SeamSource source);

/// Adds them to the curves of a file. Throws InputError as seamsOf() does.
void addSeams(SeamSource source, SurfaceContents& contents);
}
