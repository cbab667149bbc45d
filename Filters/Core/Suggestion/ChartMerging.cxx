// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/ChartMerging.h"

#include "Base/CompressedRows.h"
#include "Suggestion/OpeningCuts.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace flattening
{
namespace
{
/// Of the bound, that of the forecast for the parts of charts that do not keep it, and by what it
/// is multiplied each time; the last parts are triangles.
constexpr double dividedBound = 0.1;
constexpr double dividedShare = 0.25;
constexpr int mostDivisions = 4;
/// A chart whose forecast is more than this many times the bound is not flattened: of 8,000 merged
/// charts of animals and parts of machines 0.3 % kept the bound from there on.
constexpr double hopelessShare = 1.5;
/// A trial is given up after these steps; those of charts that keep the bound take 48 at most.
constexpr double mostChartSteps = 50.0;
/// What a forecast takes, in steps of a flattening.
constexpr double forecastSteps = 1.0;
/// More than there are threads.
constexpr std::size_t triedAtOnce = 4;
constexpr Index numberedAtOnce = 16;
/// Of bound^2, the rise of the mean square of the strain below which merging is free.
constexpr double freeRise = 1e-2;
/// Of a seam, what is sewn at once.
constexpr std::array<double, 2> sewnShares{ 2.0 / 3.0, 1.0 / 3.0 };
}

Charts::Charts(const TriangleMesh& mesh, std::vector<char> cut, Indices images,
  const ChartOptions& options, double size)
  : Mesh(mesh)
  , Cut(std::move(cut))
  , Images(std::move(images))
  , Options(options)
  , Size(size)
  , HoleOf(mesh.vertexCount(), none)
{
  const std::vector<Indices> loops = mesh.boundaryLoops();
  const std::vector<char> holes = findHoles(mesh, loops);
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (Index h : holes[l] ? loops[l] : Indices{})
    {
      this->HoleOf[mesh.from(h)] = static_cast<Index>(l);
    }
  }
}

void Charts::divide(TrialBudget& budget, const Execution& execution)
{
  double bound = dividedBound * this->Options.bound;
  this->number(budget, execution);
  for (int round = 1; round <= mostDivisions && !execution.cancelled() && !budget.spent(); ++round)
  {
    if (!this->divideOnce(round < mostDivisions ? bound : -1.0))
    {
      return;
    }
    bound *= dividedShare;
    this->number(budget, execution);
  }
}

/// False where all charts keep the bound.
bool Charts::divideOnce(double bound)
{
  bool divided = false;
  for (const Chart& chart : this->All)
  {
    if (chart.keeps || chart.triangles.size() < 2)
    {
      continue;
    }
    const TriangleMesh part = openedPart(this->Mesh, chart.triangles, this->Cut).mesh;
    const Indices parts = clusterTriangles(part, {}, {}, bound);
    for (Index h = 0; h < part.halfedgeCount(); ++h)
    {
      const Index twin = part.twin(h);
      if (twin != none && parts[h / 3] != parts[twin / 3])
      {
        const Index here = 3 * chart.triangles[h / 3] + h % 3;
        for (Index edge : { here, this->Images[here] })
        {
          this->Cut[edge] = this->Cut[this->Mesh.twin(edge)] = 1;
        }
        divided = true;
      }
    }
  }
  return divided;
}

void Charts::merge(TrialBudget& budget, const Execution& execution)
{
  this->eliminate(
    [this](const std::vector<Arc>& arcs, std::vector<Removal>& removals) {
      for (const Arc& arc : arcs)
      {
        removals.push_back(this->removalOf(arc.edges, this->Options.fixedPrice));
      }
    },
    budget, execution);
}

void Charts::shorten(TrialBudget& budget, const Execution& execution)
{
  this->eliminate(
    [this](const std::vector<Arc>& arcs, std::vector<Removal>& removals) {
      for (const Arc& arc : arcs)
      {
        const Index first = arc.edges.front();
        const bool two = this->ChartOf[first / 3] != this->ChartOf[this->Mesh.twin(first) / 3];
        for (bool front : { true, false })
        {
          const Index end = front ? arc.vertices.front() : arc.vertices.back();
          for (double share : sewnShares)
          {
            Indices part =
              two || this->degree(end) == 1 ? this->partOf(arc, front, share) : Indices{};
            if (!part.empty() && !this->ownImage(arc))
            {
              removals.push_back(this->removalOf(std::move(part), 0.0));
            }
          }
        }
      }
    },
    budget, execution);
}

/// From an edge on to the next node, or round to its start.
Charts::Arc Charts::follow(Index first, std::vector<char>& used) const
{
  Arc arc;
  arc.vertices.push_back(this->Mesh.from(first));
  for (Index h = first; h != none && !used[h];)
  {
    used[h] = used[this->Mesh.twin(h)] = 1;
    arc.edges.push_back(h);
    const Index end = this->Mesh.to(h);
    arc.vertices.push_back(end);
    h = none;
    for (Index next : this->isNode(end) ? Indices{} : this->cutEdges(end))
    {
      h = used[next] ? h : next;
    }
  }
  return arc;
}

std::vector<Charts::Arc> Charts::arcs(bool opened) const
{
  std::vector<Arc> all;
  std::vector<char> used(this->Mesh.halfedgeCount(), 0);
  for (bool closed : { false, true })
  {
    for (Index v = 0; v < this->Mesh.vertexCount(); ++v)
    {
      for (Index h : closed || this->isNode(v) ? this->cutEdges(v) : Indices{})
      {
        if (!used[h])
        {
          all.push_back(this->follow(h, used));
        }
      }
    }
  }
  std::vector<Arc> arcs;
  for (Arc& arc : all)
  {
    if (arc.vertices.front() == arc.vertices.back())
    {
      if (!opened)
      {
        arcs.push_back(std::move(arc));
        continue;
      }
      const auto half = static_cast<std::ptrdiff_t>(arc.edges.size() / 2);
      arcs.push_back({ Indices(arc.edges.begin(), arc.edges.begin() + half),
        Indices(arc.vertices.begin(), arc.vertices.begin() + half + 1) });
      arcs.push_back({ Indices(arc.edges.begin() + half, arc.edges.end()),
        Indices(arc.vertices.begin() + half, arc.vertices.end()) });
      continue;
    }
    if (this->degree(arc.vertices.front()) == 1 && this->degree(arc.vertices.back()) != 1)
    {
      std::reverse(arc.vertices.begin(), arc.vertices.end());
      std::reverse(arc.edges.begin(), arc.edges.end());
      std::transform(arc.edges.begin(), arc.edges.end(), arc.edges.begin(),
        [this](Index h) { return this->Mesh.twin(h); });
    }
    arc.dart =
      !this->Mesh.onBoundary(arc.vertices.back()) && this->degree(arc.vertices.back()) == 1;
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

/// Finds the charts and flattens each.
void Charts::number(TrialBudget& budget, const Execution& execution)
{
  JoinedSets sets(this->Mesh.triangleCount());
  for (Index h = 0; h < this->Mesh.halfedgeCount(); ++h)
  {
    if (this->Mesh.twin(h) != none && !this->Cut[h])
    {
      sets.join(h / 3, this->Mesh.twin(h) / 3);
    }
  }
  Indices number(this->Mesh.triangleCount(), none);
  this->ChartOf.clear();
  this->All.clear();
  for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
  {
    const Index first = sets.find(t);
    if (first == t)
    {
      number[t] = static_cast<Index>(this->All.size());
      this->All.emplace_back();
    }
    this->ChartOf.push_back(number[first]);
    this->All[number[first]].triangles.push_back(t);
  }
  const Execution inner = execution.nestedExecution();
  const auto count = static_cast<Index>(this->All.size());
  for (Index first = 0; first < count && !budget.spent(); first += numberedAtOnce)
  {
    const Index last = std::min(count, first + numberedAtOnce);
    std::vector<Trial> trials(last - first);
    execution.parallelFor(last - first, [&](Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
      {
        const Indices& triangles = this->All[first + k].triangles;
        trials[k] = this->tried(openedPart(this->Mesh, triangles, this->Cut).mesh, inner);
      }
    });
    for (Index k = first; k < last; ++k)
    {
      this->All[k].keeps = trials[k - first].keeps;
      budget.pay(trials[k - first].work);
    }
  }
  for (Chart& chart : this->All)
  {
    chart.version = this->Versions++;
  }
}

/// Takes one of the removals after which charts keep the bound, that first which saves most for
/// what it is forecast to cost, again and again.
void Charts::eliminate(
  const std::function<void(const std::vector<Arc>&, std::vector<Removal>&)>& list,
  TrialBudget& budget, const Execution& execution)
{
  std::map<Indices, Candidate> known;
  bool more = true;
  while (more && !budget.spent() && !execution.cancelled())
  {
    std::vector<Removal> removals;
    list(this->arcs(), removals);
    std::vector<Candidate*> order;
    std::vector<Candidate*> fresh;
    for (Removal& removal : removals)
    {
      const auto entry = known.emplace(this->keyOf(removal), Candidate());
      order.push_back(&entry.first->second);
      if (entry.second)
      {
        order.back()->removal = std::move(removal);
        fresh.push_back(order.back());
      }
    }
    execution.parallelFor(static_cast<Index>(fresh.size()), [&](Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
      {
        fresh[k]->cost = this->forecastCost(fresh[k]->removal);
      }
    });
    for (const Candidate* one : fresh)
    {
      for (Index chart : one->removal.charts)
      {
        budget.pay(forecastSteps * static_cast<double>(this->All[chart].triangles.size()));
      }
    }
    order.erase(std::remove_if(order.begin(), order.end(),
                  [](const Candidate* one) {
                    return std::isinf(one->cost) || (one->tried && !one->trial.keeps);
                  }),
      order.end());
    std::stable_sort(order.begin(), order.end(), [](const Candidate* a, const Candidate* b) {
      return a->removal.saved * b->cost > b->removal.saved * a->cost;
    });
    more = this->removeFirst(order, budget, execution);
  }
}

/// The first of the candidates that keeps the bound. False where none does.
bool Charts::removeFirst(
  const std::vector<Candidate*>& order, TrialBudget& budget, const Execution& execution)
{
  const Execution inner = execution.nestedExecution();
  for (std::size_t first = 0; first < order.size() && !budget.spent(); first += triedAtOnce)
  {
    const std::size_t last = std::min(order.size(), first + triedAtOnce);
    execution.parallelFor(static_cast<Index>(last - first), [&](Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
      {
        Candidate& one = *order[first + k];
        if (!one.tried)
        {
          one.trial = this->tried(this->without(one.removal).mesh, inner);
        }
      }
    });
    for (std::size_t k = first; k < last; ++k)
    {
      if (!order[k]->tried)
      {
        budget.pay(order[k]->trial.work);
        order[k]->tried = true;
      }
    }
    for (std::size_t k = first; k < last; ++k)
    {
      if (order[k]->trial.keeps)
      {
        this->remove(order[k]->removal);
        return true;
      }
    }
  }
  return false;
}

/// The charts beside the edges become one, and their images.
void Charts::remove(const Removal& removal)
{
  for (Index h : removal.edges)
  {
    this->Cut[h] = this->Cut[this->Mesh.twin(h)] = 0;
    const std::array<Index, 2> sides{ this->ChartOf[h / 3], this->ChartOf[this->Mesh.twin(h) / 3] };
    const auto [kept, lost] = std::minmax(sides[0], sides[1]);
    Chart& chart = this->All[kept];
    chart.keeps = true;
    chart.version = this->Versions++;
    if (lost != kept)
    {
      Indices& gone = this->All[lost].triangles;
      for (Index t : gone)
      {
        this->ChartOf[t] = kept;
      }
      chart.triangles.insert(chart.triangles.end(), gone.begin(), gone.end());
      gone.clear();
    }
  }
}

Charts::Trial Charts::tried(const TriangleMesh& part, const Execution& execution) const
{
  TrialBudget budget(mostChartSteps * static_cast<double>(part.triangleCount()));
  const TrialOutcome outcome =
    CutTrials(part, {}, {}, this->Options.flattening).run({}, budget, execution);
  return { outcome.valid && outcome.flipped == 0 && outcome.overlaps == 0 &&
      outcome.strainP95 <= this->Options.bound,
    budget.work() };
}

/// The charts beside the edges with them sewn.
OpenedPart Charts::without(const Removal& removal) const
{
  std::vector<char> cut = this->Cut;
  for (Index h : removal.edges)
  {
    cut[h] = cut[this->Mesh.twin(h)] = 0;
  }
  Indices triangles;
  for (Index chart : removal.charts)
  {
    const Indices& more = this->All[chart].triangles;
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  return openedPart(this->Mesh, triangles, cut);
}

double Charts::forecastCost(const Removal& removal) const
{
  const OpenedPart part = this->without(removal);
  const double strain =
    this->isDisk(part) ? forecastStrain(part.mesh) : std::numeric_limits<double>::infinity();
  const double bound = this->Options.bound;
  return strain > hopelessShare * bound
    ? std::numeric_limits<double>::infinity()
    : (strain * strain + freeRise * bound * bound) * part.mesh.area();
}

/// Holes filled.
bool Charts::isDisk(const OpenedPart& part) const
{
  Index euler = eulerCharacteristic(part.mesh);
  for (const Indices& loop : part.mesh.boundaryLoops())
  {
    const bool hole = std::all_of(loop.begin(), loop.end(),
      [&](Index h) { return this->HoleOf[part.vertices[part.mesh.from(h)]] != none; });
    euler += hole ? 1 : 0;
  }
  return euler == 1;
}

Charts::Removal Charts::removalOf(Indices edges, double fixedPrice) const
{
  const double own = this->length(edges);
  for (std::size_t k = edges.size(); k-- > 0;)
  {
    edges.push_back(this->Images[edges[k]]);
  }
  for (Index& h : edges)
  {
    h = std::min(h, this->Mesh.twin(h));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  // The charts that become one with that at the first edge.
  Removal removal;
  removal.charts = { this->ChartOf[edges.front() / 3] };
  const auto has = [&](Index chart) {
    return std::find(removal.charts.begin(), removal.charts.end(), chart) != removal.charts.end();
  };
  std::vector<char> joined(edges.size(), 0);
  double length = 0.0;
  for (bool more = true; more;)
  {
    more = false;
    for (std::size_t k = 0; k < edges.size(); ++k)
    {
      const std::array<Index, 2> sides{ this->ChartOf[edges[k] / 3],
        this->ChartOf[this->Mesh.twin(edges[k]) / 3] };
      if (joined[k] || (!has(sides[0]) && !has(sides[1])))
      {
        continue;
      }
      joined[k] = 1;
      more = true;
      length += this->Mesh.length(edges[k]);
      for (Index side : sides)
      {
        if (!has(side))
        {
          removal.charts.push_back(side);
        }
      }
    }
  }
  // As much as both of a pair, where both are of the one chart.
  removal.saved = fixedPrice * length / own + length / this->Size;
  removal.edges = std::move(edges);
  return removal;
}

Indices Charts::keyOf(const Removal& removal) const
{
  Indices key = removal.edges;
  for (Index chart : removal.charts)
  {
    key.push_back(-1 - this->All[chart].version);
  }
  return key;
}

Indices Charts::cutEdges(Index v) const
{
  Indices edges;
  for (Index h : VertexFan(this->Mesh, v))
  {
    if (this->Cut[h])
    {
      edges.push_back(h);
    }
  }
  return edges;
}

/// How many cut edges meet at a vertex, or at the hole that it is on; many at another boundary.
std::size_t Charts::degree(Index v) const
{
  if (!this->Mesh.onBoundary(v))
  {
    return this->cutEdges(v).size();
  }
  if (this->HoleOf[v] == none)
  {
    return this->Mesh.vertexCount();
  }
  std::size_t count = 0;
  for (Index w = 0; w < this->Mesh.vertexCount(); ++w)
  {
    count += this->HoleOf[w] == this->HoleOf[v] ? this->cutEdges(w).size() : 0;
  }
  return count;
}

bool Charts::isNode(Index v) const
{
  return this->Mesh.onBoundary(v) || this->cutEdges(v).size() != 2;
}

/// Whether an arc runs across the mirror plane.
bool Charts::ownImage(const Arc& arc) const
{
  const Index image = this->Images[arc.edges.front()];
  return arc.edges.size() > 1 && std::any_of(arc.edges.begin() + 1, arc.edges.end(), [&](Index h) {
    return h == image || this->Mesh.twin(h) == image;
  });
}

double Charts::length(const Indices& edges) const
{
  return std::accumulate(edges.begin(), edges.end(), 0.0,
    [this](double sum, Index h) { return sum + this->Mesh.length(h); });
}

/// The edges of an arc from an end on, about a share of it. None where no dart is left.
Indices Charts::partOf(const Arc& arc, bool front, double share) const
{
  const double whole = this->length(arc.edges);
  Indices part;
  double sum = 0.0;
  for (std::size_t k = 0; k < arc.edges.size(); ++k)
  {
    const Index h = arc.edges[front ? k : arc.edges.size() - 1 - k];
    const double step = this->Mesh.length(h);
    if (sum + 0.5 * step > share * whole)
    {
      break;
    }
    sum += step;
    part.push_back(h);
  }
  return whole - sum < this->Options.leastDart * this->Size ? Indices{} : part;
}
}
