// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/BorderChains.h"

#include <cmath>
#include <numeric>

namespace flattening::pattern
{
namespace
{
/// A turn is a corner from here on whatever is beside it; radians.
constexpr double sharpTurn = pi / 3.0;
/// One from here on if the turns beside it are much less: coarse meshes turn by 40 degrees from
/// edge to edge where the curve is round.
constexpr double leastTurn = pi / 6.0;
constexpr double roundTurn = pi / 12.0;
constexpr double leastBeside = pi / 36.0;
constexpr double timesNeighbour = 1.8;
/// A curve as long as its edges runs within their corners, where it is round by edge * turn / 24,
/// and by about edge * turn / 16 where it bends at one of them alone.
constexpr double depthOfRound = 24.0;
constexpr double depthOfBend = 16.0;
constexpr double surely = 1.5;     ///< tolerances: more is too much
constexpr double collapsed = 1e-9; ///< part of a chain that an edge without length takes
}

BorderChains::BorderChains(const DrawingSource& all)
{
  for (std::size_t p = 0; p < all.loops.size(); ++p)
  {
    for (const Indices& loop : all.loops[p])
    {
      this->add(all, p, loop, true);
    }
  }
  this->addInnerCurves(all);
}

std::optional<ChainEdge> BorderChains::find(Index from, Index to) const
{
  const auto found = this->Edges.find(undirectedKey(from, to));
  if (found == this->Edges.end())
  {
    return std::nullopt;
  }
  const auto [chain, edge] = found->second;
  return ChainEdge{ chain, edge, this->Chains[chain].point(edge) != from };
}

std::size_t BorderChains::chainsAt(Index point) const
{
  const auto found = this->Count.find(point);
  return found == this->Count.end() ? 0 : found->second;
}

void BorderChains::addInnerCurves(const DrawingSource& all)
{
  for (const SourceWire& wire : all.source.wires)
  {
    if (wire.piece == none)
    {
      continue;
    }
    Indices run;
    const auto end = [&] {
      if (run.size() > 1)
      {
        const bool closed = run.size() > 3 && run.front() == run.back();
        run.resize(run.size() - (closed ? 1 : 0));
        this->add(all, static_cast<std::size_t>(wire.piece), run, closed);
      }
      run.clear();
    };
    for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
    {
      const Index from = wire.points[k];
      const Index to = wire.points[k + 1];
      if (this->Edges.count(undirectedKey(from, to)) > 0)
      {
        end();
        continue;
      }
      if (run.empty())
      {
        run.push_back(from);
      }
      run.push_back(to);
    }
    end();
  }
}

void BorderChains::add(
  const DrawingSource& all, std::size_t piece, const Indices& points, bool closed)
{
  BorderChain chain;
  chain.piece = piece;
  chain.closed = closed;
  chain.points = points;
  this->findCorners(all, chain);
  if (closed)
  {
    // The first point of a ring is a corner if there is one.
    const auto first = std::find(chain.corner.begin(), chain.corner.end(), true);
    const auto shift = first == chain.corner.end() ? 0 : first - chain.corner.begin();
    std::rotate(chain.corner.begin(), chain.corner.begin() + shift, chain.corner.end());
    std::rotate(chain.turns.begin(), chain.turns.begin() + shift, chain.turns.end());
    std::rotate(chain.bends.begin(), chain.bends.begin() + shift, chain.bends.end());
    std::rotate(chain.points.begin(), chain.points.begin() + shift, chain.points.end());
  }
  chain.arc.push_back(0.0);
  const std::size_t edges = points.size() - (closed ? 0 : 1);
  std::vector<double> lengths;
  for (std::size_t k = 0; k < edges; ++k)
  {
    lengths.push_back((all.at(chain.point(k + 1)) - all.at(chain.point(k))).norm());
  }
  // Every edge takes a part of the chain, so that places divide by it, also where it has collapsed.
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const double least = collapsed * (whole > 0.0 ? whole : 1.0);
  for (std::size_t k = 0; k < edges; ++k)
  {
    const Index from = chain.point(k);
    const Index to = chain.point(k + 1);
    chain.arc.push_back(chain.arc.back() + std::max(lengths[k], least));
    this->Edges.emplace(
      undirectedKey(from, to), std::array<std::size_t, 2>{ this->Chains.size(), k });
  }
  for (const Index v : chain.points)
  {
    ++this->Count[v];
  }
  this->Chains.push_back(std::move(chain));
}

void BorderChains::findCorners(const DrawingSource& all, BorderChain& chain)
{
  const std::size_t count = chain.points.size();
  std::vector<double> turn(count, 0.0);
  std::vector<double> tolerances; // from each point to the next
  for (std::size_t k = 0; k < count; ++k)
  {
    tolerances.push_back(all.fairToleranceAlong(chain.points[k], chain.points[(k + 1) % count]));
  }
  const std::size_t ends = chain.closed ? 0 : 1;
  for (std::size_t k = ends; k + ends < count; ++k)
  {
    const Point2 at = all.at(chain.points[k]);
    const Point2 before = at - all.at(chain.points[(k + count - 1) % count]);
    const Point2 after = all.at(chain.points[(k + 1) % count]) - at;
    turn[k] = std::atan2(cross(before, after), before.dot(after));
  }
  chain.turns.assign(count, false);
  chain.bends.assign(count, 0.0);
  chain.corner.assign(count, false);
  for (std::size_t k = 0; k < count; ++k)
  {
    const double sign = turn[k] < 0.0 ? -1.0 : 1.0;
    double beside = leastBeside;
    for (const std::size_t neighbour : { (k + count - 1) % count, (k + 1) % count })
    {
      // A corner at the other end of a long edge makes no round of this one.
      const double same = sign * turn[neighbour];
      beside = same > sharpTurn ? beside : std::max(beside, same);
    }
    const double own = std::abs(turn[k]);
    const double tolerance = std::min(tolerances[(k + count - 1) % count], tolerances[k]);
    const Point2 at = all.at(chain.points[k]);
    const double edge = ((at - all.at(chain.points[(k + count - 1) % count])).norm() +
                          (all.at(chain.points[(k + 1) % count]) - at).norm()) /
      2.0;
    const bool alone = own > timesNeighbour * beside;
    const double bend = own * edge / (alone ? depthOfBend : depthOfRound);
    chain.turns[k] =
      own > sharpTurn || (own > leastTurn && own > timesNeighbour * std::max(beside, roundTurn));
    chain.bends[k] = !chain.turns[k] && tolerance > 0.0 && bend > surely * tolerance ? bend : 0.0;
    chain.corner[k] = chain.turns[k] || chain.bends[k] > 0.0;
  }
  // Where what is smooth meets what stays as it is.
  for (std::size_t k = ends; k + ends < count; ++k)
  {
    const double before = tolerances[(k + count - 1) % count];
    chain.corner[k] = chain.corner[k] || (before > 0.0) != (tolerances[k] > 0.0);
  }
  if (!chain.closed)
  {
    chain.corner.front() = chain.corner.back() = true;
  }
}
}
