// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// Two boundary edges of the cut surface that were one edge before: they are sewn to each other.
struct SeamPair
{
  Index first = none;  ///< half-edge
  Index second = none; ///< half-edge, in the opposite direction
  Index curve = none;  ///< the dart or seam
};

/// A surface whose darts and seams are open. Triangles and half-edges keep their ids, unless pieces
/// were left out (see withoutPieces()).
struct CutSurface
{
  TriangleMesh mesh;
  Indices originalVertex;
  Index originalVertexCount = 0; ///< of the surface before the cut
  /// Per triangle its id before the cut, where pieces were left out; else empty, because all have
  /// kept theirs.
  Indices keptTriangles;
  /// Per half-edge the feature curve that it lies on, else none. Both sides of an edge agree, also
  /// where the edge was cut.
  Indices curveOfHalfedge;
  std::vector<SeamPair> seamPairs;
  /// Per triangle its piece: the connected components, in the order of their smallest triangle id.
  Indices pieceOfTriangle;
  Index pieceCount = 0;
  Status status;

  /// The triangle's id before the cut.
  Index originalTriangle(Index triangle) const
  {
    return this->keptTriangles.empty() ? triangle : this->keptTriangles[triangle];
  }
};

/// What the cut needs to know of the feature curves.
struct CurveLabels
{
  Indices curveOfHalfedge; ///< as in CutSurface
  std::vector<char> opens; ///< by curve: a dart or a seam
  Status status;

  bool opensAt(Index halfedge) const
  {
    const Index curve = this->curveOfHalfedge[halfedge];
    return curve != none && this->opens[curve] != 0;
  }
};

/// Finds the half-edges of the feature curves. Where curves share an edge, seam goes before dart,
/// dart before key, key before accessory, and the earlier curve before the later.
///
/// Errors: EmptySurface, CurveTooShort, CurveNotOnEdges (ids: the vertices of the segment that is no
/// mesh edge), InvalidPointId, InvalidCurve (an unknown type, a tolerance outside [0, 1), or a
/// planar shape that has not one finite point a vertex; ids: curves).
CurveLabels labelHalfedges(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves);

/// Opens darts and seams (Definition 3) and finds the pieces.
///
/// A vertex gets one copy for each fan of triangles that the cuts leave around it, so a curve that
/// ends on a cut stays with the copy on its own side. \pre the labels are sound.
CutSurface openCuts(const TriangleMesh& mesh, CurveLabels labels);
/// Both of them. Errors: those of labelHalfedges().
CutSurface cutSurface(const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves);

/// One piece as a mesh of its own.
struct Piece
{
  TriangleMesh mesh;
  Indices vertices;  ///< per vertex its id in the cut surface
  Indices triangles; ///< per triangle its id in the cut surface
  Indices curveOfHalfedge;
};

/// All pieces of a cut surface.
std::vector<Piece> extractPieces(const CutSurface& cut);

/// An end of a dart or seam one edge inside the boundary, which was likely meant to lie on it.
struct ShortEnd
{
  Index curve = none;
  Index vertex = none;   ///< the end
  Index boundary = none; ///< its neighbour on the boundary that continues the curve best
};

/// Ends of cuts that stop one edge short of the boundary: of a seam each that lies neither on the
/// boundary nor on another cut, of a dart the nearer one where both are so, since its tip is free.
/// \pre the curves run along edges of the mesh.
std::vector<ShortEnd> endsShortOfBoundary(
  const TriangleMesh& mesh, const std::vector<FeatureCurve>& curves);
}
