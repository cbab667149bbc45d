// SPDX-License-Identifier: BSD-3-Clause
#include "Wires/DartBanks.h"

namespace flattening
{
namespace
{
class BankSearch
{
public:
  BankSearch(const WireNetwork& network, const Piece& piece, const CutSurface& cut)
    : Network(network)
    , Cloth(piece)
    , Cut(cut)
  {
  }

  void add(Index id, const FeatureCurve& curve, std::vector<DartBankVertex>& banks) const
  {
    Indices placeOf(this->Cut.originalVertexCount, none);
    const auto count = static_cast<Index>(curve.vertices.size());
    for (Index k = 1; k + 1 < count; ++k)
    {
      placeOf[curve.vertices[k]] = k;
    }
    for (std::size_t host = 0; host < this->Network.hostVertices.size(); ++host)
    {
      const Index k = placeOf[this->original(this->Network.hostVertices[host])];
      if (k == none)
      {
        continue;
      }
      const Index last = curve.vertices[k - 1];
      const Index next = curve.vertices[k + 1];
      DartBankVertex left = this->bankAt(static_cast<Index>(host), next, last);
      DartBankVertex right = this->bankAt(static_cast<Index>(host), last, next);
      if (left.nodes.empty() == right.nodes.empty())
      {
        continue; // branches off, or joined
      }
      left.onLeft = !left.nodes.empty();
      DartBankVertex& bank = left.onLeft ? left : right;
      bank.curve = id;
      bank.place = k;
      banks.push_back(std::move(bank));
    }
  }

private:
  Index original(Index v) const { return this->Cut.originalVertex[this->Cloth.vertices[v]]; }

  /// The bank that comes from one vertex of the curve and goes on to another; without nodes where
  /// there is none.
  DartBankVertex bankAt(Index host, Index to, Index from) const
  {
    DartBankVertex bank;
    bank.host = host;
    Index start = none;
    for (Index n = this->Network.vertexNodeBegin[host]; n < this->Network.vertexNodeBegin[host + 1];
         ++n)
    {
      const Index side = this->Network.vertexNodes[n];
      const Index incoming = this->Network.previous[side];
      if (this->Network.isHole(this->Network.loop[side]))
      {
        continue;
      }
      if (this->original(this->Network.endVertex(side)) == to)
      {
        start = side;
        bank.after = this->Network.endVertex(side);
      }
      if (this->original(this->Network.vertex[incoming]) == from)
      {
        bank.before = this->Network.vertex[incoming];
      }
    }
    if (start != none && bank.before != none)
    {
      bank.nodes = nodesBetween(this->Network, start, bank.before);
    }
    return bank;
  }

  const WireNetwork& Network;
  const Piece& Cloth;
  const CutSurface& Cut;
};
}

Indices nodesBetween(const WireNetwork& network, Index startSide, Index endVertex)
{
  Indices nodes;
  Index side = startSide;
  do
  {
    nodes.push_back(side);
    const Index incoming = network.previous[side];
    if (network.vertex[incoming] == endVertex)
    {
      return nodes;
    }
    side = network.twin[incoming];
  } while (side != none && side != startSide);
  return {};
}

std::vector<DartBankVertex> findDartBanks(const WireNetwork& network, const Piece& piece,
  const CutSurface& cut, const std::vector<FeatureCurve>& curves)
{
  std::vector<DartBankVertex> banks;
  const BankSearch search(network, piece, cut);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (curves[c].type == CurveType::Dart && !curves[c].closed())
    {
      search.add(static_cast<Index>(c), curves[c], banks);
    }
  }
  return banks;
}
}
