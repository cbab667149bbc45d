// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/FlatteningCache.h"

namespace flattening
{
bool FlatteningCache::isValidFor(
  const TriangleMesh& surface, const CurveLabels& labels, bool skip) const
{
  const bool whole = this->leftOut.empty();
  const bool asAsked = skip ? this->topology.ok() : whole;
  return this->cut && asAsked && this->opens == labels.opens &&
    (whole ? this->cut->curveOfHalfedge : this->curveOfHalfedge) == labels.curveOfHalfedge &&
    this->mesh.identical(surface);
}

void FlatteningCache::renew(const TriangleMesh& surface, CurveLabels labels, bool skip, bool keep)
{
  this->mesh = {};
  this->opens = labels.opens;
  this->curveOfHalfedge.clear();
  this->leftOut.clear();
  CutSurface opened = openCuts(surface, std::move(labels));
  std::vector<Piece> renewed = extractPieces(opened);
  const std::vector<std::optional<PieceDefect>> defects = findDefects(renewed);
  this->topology = refusalOf(defects);
  std::vector<char> out;
  for (const std::optional<PieceDefect>& defect : defects)
  {
    out.push_back(defect ? 1 : 0);
    if (skip && defect)
    {
      this->leftOut.push_back(*defect);
    }
  }
  if (this->leftOut.size() == renewed.size())
  {
    this->leftOut.clear(); // nothing would remain
  }
  if (!this->leftOut.empty())
  {
    this->topology = {};
    this->curveOfHalfedge = opened.curveOfHalfedge;
    opened = withoutPieces(opened, out);
    renewed = extractPieces(opened);
  }
  this->cut = std::make_shared<const CutSurface>(std::move(opened));
  this->pieces.resize(renewed.size());
  for (std::size_t p = 0; p < renewed.size(); ++p)
  {
    // Factors alone may fit another cut: each patch checks its own.
    InteriorSystems interiors = std::move(this->pieces[p].interiors);
    interiors.current = false;
    this->pieces[p] = { std::move(renewed[p]), this->topology.ok(), {}, std::move(interiors), {},
      {} };
  }
  if (keep)
  {
    this->mesh = surface;
  }
}
}
