// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/FlatteningCache.h"

namespace flattening
{
bool FlatteningCache::serves(const TriangleMesh& surface, const CurveLabels& labels) const
{
  return this->cut && this->opens == labels.opens &&
    this->cut->curveOfHalfedge == labels.curveOfHalfedge && this->mesh.identical(surface);
}

void FlatteningCache::renew(const TriangleMesh& surface, CurveLabels labels, bool keep)
{
  this->mesh = {};
  this->opens = labels.opens;
  this->cut = std::make_shared<const CutSurface>(openCuts(surface, std::move(labels)));
  std::vector<Piece> renewed = extractPieces(*this->cut);
  this->pieces.resize(renewed.size());
  for (std::size_t p = 0; p < renewed.size(); ++p)
  {
    WiredPiece& wired = this->pieces[p];
    wired.piece = std::move(renewed[p]);
    wired.network.reset();
    wired.interiors.current = false;
    wired.measures.reset();
  }
  if (keep)
  {
    this->mesh = surface;
  }
}
}
