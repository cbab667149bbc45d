// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/ChartMerging.h"

#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/OpeningCuts.h"
#include "Suggestion/SeamDrawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace flattening
{
namespace
{
/// Of the bound, that of the forecast for the parts of charts that do not keep it, and by what it
/// is multiplied each time; the last parts are triangles.
constexpr double dividedBound = 0.5;
constexpr double dividedShare = 0.3;
constexpr int maxDivisions = 4;
/// More than there are threads. In a single chart, of which flattenings are long, one.
constexpr std::size_t triedAtOnce = 4;
/// Cuts in a single chart that are sewn at once, at most.
constexpr std::size_t mostTogether = 8;
/// Of bound^2, the rise of the mean square of the strain below which merging is free.
constexpr double freeRise = 1e-2;
/// Where a number of charts is wanted: by what the bound is multiplied, and up to where.
constexpr double raisedBound = 1.3;
constexpr double greatestBound = 1.0;
/// To list and order a removal, in steps of a flattening; measured on 29,000 triangles.
constexpr double listingSteps = 1.0;
/// A seam along a sharp edge costs as much as one of this share of its length: it is seen anyway.
constexpr double creaseShare = 0.5;
/// Of a seam, what is sewn at once.
constexpr std::array<double, 2> sewnShares{ 2.0 / 3.0, 1.0 / 3.0 };
}

Charts::Charts(const TriangleMesh& mesh, std::vector<char> cut, Indices images,
  const ChartOptions& options, double size, ChartTrials& trials)
  : Mesh(mesh)
  , Cut(std::move(cut))
  , Images(std::move(images))
  , Options(options)
  , Bound(options.bound)
  , Fewest(std::max<Index>(1, options.pieces))
  , Size(size)
  , Trials(trials)
{
  const std::vector<char> creases = creasesOf(mesh, sharpCosine);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    this->Prices.push_back((creases[h] ? creaseShare : 1.0) * mesh.length(h));
  }
  const std::vector<Indices> loops = options.holes ? mesh.boundaryLoops() : std::vector<Indices>{};
  this->HoleOf = holesByVertex(mesh, loops, findHoles(mesh, loops));
}

void Charts::divide(TrialBudget& budget, const Execution& execution)
{
  double bound = dividedBound * this->Bound;
  this->number(budget, execution);
  for (int round = 1; round <= maxDivisions && !execution.cancelled() && !budget.spent(); ++round)
  {
    if (std::all_of(this->All.begin(), this->All.end(),
          [](const Chart& chart) { return chart.keeps || chart.triangles.size() < 2; }))
    {
      return;
    }
    this->divideOnce(round < maxDivisions ? bound : -1.0);
    bound *= dividedShare;
    this->number(budget, execution);
  }
}

/// Charts that do not keep the bound become clusters, or, where it is an overlap that these do not
/// know of, halves.
void Charts::divideOnce(double bound)
{
  for (const Chart& chart : this->All)
  {
    if (chart.keeps || chart.triangles.size() < 2)
    {
      continue;
    }
    const TriangleMesh part = openedPart(this->Mesh, chart.triangles, this->Cut).mesh;
    Indices parts = clusterTriangles(part, {}, {}, bound);
    if (std::all_of(parts.begin(), parts.end(), [&](Index one) { return one == parts.front(); }))
    {
      parts = halvesOf(part);
    }
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
      }
    }
  }
}

std::vector<char> Charts::keeping(TrialBudget& budget, const Execution& execution)
{
  this->number(budget, execution);
  std::vector<char> keeping;
  for (Index chart : this->ChartOf)
  {
    keeping.push_back(this->All[chart].keeps ? 1 : 0);
  }
  return keeping;
}

void Charts::merge(bool sharing, TrialBudget& budget, const Execution& execution)
{
  this->Together = 2;
  this->eliminate(
    [this, sharing](const std::vector<CutArc>& arcs, std::vector<Removal>& removals) {
      for (const CutArc& arc : arcs)
      {
        removals.push_back(this->removalOf(arc.edges, cutPrice));
      }
      // Large charts rarely fit beside others, and take long to try.
      const auto mean = static_cast<std::size_t>(this->Mesh.triangleCount()) / this->All.size();
      Indices owner(sharing ? this->Mesh.triangleCount() : 0, none);
      for (std::size_t c = 0; sharing && c < this->All.size(); ++c)
      {
        if (this->All[c].triangles.size() > mean)
        {
          continue;
        }
        Removal removal = this->sharedOut(static_cast<Index>(c), owner);
        for (Index t : this->All[c].triangles)
        {
          owner[t] = owner[this->imageOf(t)] = none;
        }
        if (removal.saved > 0.0)
        {
          removals.push_back(std::move(removal));
        }
      }
    },
    budget, execution);
}

double Charts::mergeToFewest(TrialBudget& budget, const Execution& execution)
{
  const auto more = [&] { return static_cast<Index>(this->All.size()) > this->Fewest; };
  while (more() && this->Bound < greatestBound && !budget.spent() && !execution.cancelled())
  {
    this->merge(false, budget, execution);
    this->Bound *= more() ? raisedBound : 1.0;
  }
  return this->Bound;
}

void Charts::shorten(TrialBudget& budget, const Execution& execution)
{
  this->Together = 1; // parts of one cut may be others' as well
  this->eliminate(
    [this](const std::vector<CutArc>& arcs, std::vector<Removal>& removals) {
      for (const CutArc& arc : arcs)
      {
        const Index first = arc.edges.front();
        const bool two = this->ChartOf[first / 3] != this->ChartOf[this->Mesh.twin(first) / 3];
        for (bool front : { true, false })
        {
          for (double share : sewnShares)
          {
            Indices part = two || (front ? arc.frontFree : arc.backFree)
              ? this->partOf(arc, front, share)
              : Indices{};
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

/// Finds the charts. Those without a triangle that changed are as before.
void Charts::group(const std::vector<char>& changed)
{
  const std::vector<Chart> before = std::exchange(this->All, {});
  const Indices chartBefore = std::exchange(this->ChartOf, {});
  this->All.assign(connectedParts(this->Mesh, this->Cut, this->ChartOf), {});
  for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
  {
    Chart& chart = this->All[this->ChartOf[t]];
    if (chart.triangles.empty())
    {
      chart.version = changed[t] ? this->Versions++ : before[chartBefore[t]].version;
    }
    chart.triangles.push_back(t);
  }
}

/// Finds the charts and flattens each.
void Charts::number(TrialBudget& budget, const Execution& execution)
{
  this->group(std::vector<char>(this->Mesh.triangleCount(), 1));
  std::vector<std::vector<TriangleMesh>> parts;
  for (const Chart& chart : this->All)
  {
    parts.push_back({ openedPart(this->Mesh, chart.triangles, this->Cut).mesh });
  }
  const std::vector<ChartTrials::Result> results =
    this->Trials.run(parts, this->Bound, budget, execution);
  this->Lying = results.size() == 1 ? results.front().corners : std::vector<FlatCorners>();
  for (std::size_t c = 0; c < results.size(); ++c)
  {
    this->All[c].keeps = results[c].keeps(this->Bound);
  }
}

/// Takes removals after which charts keep the bound, those first which save most for what they are
/// forecast to cost, again and again.
void Charts::eliminate(
  const std::function<void(const std::vector<CutArc>&, std::vector<Removal>&)>& list,
  TrialBudget& budget, const Execution& execution)
{
  std::map<Indices, Candidate> known;
  this->Needed.clear();
  bool more = true;
  while (more && !budget.spent() && !execution.cancelled())
  {
    std::vector<Removal> removals;
    list(this->arcs(), removals);
    budget.pay(listingSteps * static_cast<double>(removals.size()));
    if (static_cast<Index>(this->All.size()) <= this->Fewest)
    {
      eraseIf(removals, [](const Removal& one) { return one.charts.size() > one.left; });
    }
    std::vector<Candidate*> order;
    std::vector<Candidate*> fresh;
    for (Removal& removal : removals)
    {
      const auto entry = known.emplace(this->keyOf(removal), Candidate());
      order.push_back(&entry.first->second);
      order.back()->removal = std::move(removal); // charts have other numbers now
      // What one piece cannot do without it can do without no better when others are sewn.
      const bool needed = this->Needed.count(order.back()->removal.edges) > 0;
      order.back()->tried = order.back()->tried || needed;
      if (entry.second && !order.back()->tried)
      {
        fresh.push_back(order.back());
        for (Index chart : order.back()->removal.charts)
        {
          budget.pay(static_cast<double>(this->All[chart].triangles.size())); // a step
        }
      }
    }
    execution.forEachTask(static_cast<Index>(fresh.size()),
      [&](Index k) { fresh[k]->cost = this->forecastCost(fresh[k]->removal); });
    eraseIf(order,
      [](const Candidate* one) { return std::isinf(one->cost) || (one->tried && !one->keeps); });
    std::stable_sort(order.begin(), order.end(), [](const Candidate* a, const Candidate* b) {
      return a->removal.saved * b->cost > b->removal.saved * a->cost;
    });
    more =
      this->removeTogether(order, budget, execution) || this->removeFirst(order, budget, execution);
  }
}

/// The first cuts in a single chart, twice as many as the last time, or fewer where these are too
/// many for the bound. False where only single ones can be removed.
bool Charts::removeTogether(
  const std::vector<Candidate*>& order, TrialBudget& budget, const Execution& execution)
{
  while (this->All.size() == 1 && std::min(order.size(), this->Together) > 1 && !budget.spent())
  {
    Removal all = order.front()->removal;
    const std::size_t count = std::min(order.size(), this->Together);
    for (std::size_t k = 1; k < count; ++k)
    {
      const Removal& one = order[k]->removal;
      all.edges.insert(all.edges.end(), one.edges.begin(), one.edges.end());
      all.saved += one.saved;
    }
    sortUnique(all.edges);
    const ChartTrials::Result flat = this->tryWithout({ &all }, budget, execution).front();
    if (flat.keeps(this->Bound))
    {
      this->remove({ &all }, { 1 }, flat);
      this->Together = std::min(2 * count, mostTogether);
      return true;
    }
    this->Together = count / 2;
  }
  return false;
}

/// What becomes of the charts after each removal.
std::vector<ChartTrials::Result> Charts::tryWithout(
  const std::vector<const Removal*>& removals, TrialBudget& budget, const Execution& execution)
{
  std::vector<std::vector<TriangleMesh>> sets;
  for (const Removal* one : removals)
  {
    sets.emplace_back();
    for (OpenedPart& part : this->without(*one))
    {
      sets.back().push_back(std::move(part.mesh));
    }
  }
  std::vector<ChartTrials::Result> results =
    this->Trials.run(sets, this->Bound, budget, execution, this->Lying);
  for (std::size_t k = 0; k < removals.size(); ++k)
  {
    results[k].sound = results[k].keeps(this->Bound) &&
      this->worthIt(*removals[k], results[k].waste, budget, execution);
  }
  return results;
}

/// The first of the candidates that keep the bound, and of those tried with it what changes other
/// charts. False where none does.
bool Charts::removeFirst(
  const std::vector<Candidate*>& order, TrialBudget& budget, const Execution& execution)
{
  const std::size_t together = this->All.size() == 1 ? 1 : triedAtOnce;
  for (std::size_t first = 0; first < order.size() && !budget.spent(); first += together)
  {
    const std::size_t last = std::min(order.size(), first + together);
    std::vector<const Removal*> removals;
    for (std::size_t k = first; k < last; ++k)
    {
      removals.push_back(&order[k]->removal);
    }
    const std::vector<ChartTrials::Result> results = this->tryWithout(removals, budget, execution);
    for (std::size_t k = first; k < last; ++k)
    {
      order[k]->tried = true;
      order[k]->keeps = results[k - first].keeps(this->Bound);
      if (!order[k]->keeps && this->Options.pieces == 1 && this->All.size() == 1)
      {
        this->Needed.insert(order[k]->removal.edges);
      }
    }
    std::vector<const Removal*> kept;
    std::size_t firstKept = 0;
    std::vector<char> touched(this->All.size(), 0);
    for (std::size_t k = first; k < last; ++k)
    {
      const Indices beside = this->chartsBeside(*removals[k - first]);
      const bool apart = std::none_of(
        beside.begin(), beside.end(), [&touched](Index chart) { return touched[chart] == 1; });
      if (order[k]->keeps && apart && (kept.empty() || this->Options.pieces == 0))
      {
        firstKept = kept.empty() ? k - first : firstKept;
        kept.push_back(removals[k - first]);
        for (Index chart : beside)
        {
          touched[chart] = 1;
        }
      }
    }
    if (!kept.empty())
    {
      this->remove(kept, touched, results[firstKept]);
      return true;
    }
  }
  return false;
}

/// Those that a removal changes.
Indices Charts::chartsBeside(const Removal& removal) const
{
  Indices beside;
  for (const Indices* edges : { &removal.edges, &removal.opened })
  {
    for (Index h : *edges)
    {
      beside.push_back(this->ChartOf[h / 3]);
      beside.push_back(this->ChartOf[this->Mesh.twin(h) / 3]);
    }
  }
  sortUnique(beside);
  return beside;
}

/// Whether what is saved is more than the price of what the pieces waste more, where their number
/// is free.
bool Charts::worthIt(
  const Removal& removal, double waste, TrialBudget& budget, const Execution& execution)
{
  if (this->Options.pieces > 0)
  {
    return true;
  }
  std::vector<TriangleMesh> before;
  for (Index chart : removal.charts)
  {
    before.push_back(openedPart(this->Mesh, this->All[chart].triangles, this->Cut).mesh);
  }
  constexpr double any = std::numeric_limits<double>::infinity();
  const double wasted = this->Trials.run({ before }, any, budget, execution).front().waste;
  return removal.saved > wastePrice * (waste - wasted) / (pi * this->Size * this->Size);
}

/// The cut edges as they are after a removal.
std::vector<char> Charts::cutAfter(const Removal& removal) const
{
  std::vector<char> cut = this->Cut;
  for (const Indices* edges : { &removal.edges, &removal.opened })
  {
    for (Index h : *edges)
    {
      cut[h] = cut[this->Mesh.twin(h)] = edges == &removal.opened ? 1 : 0;
    }
  }
  return cut;
}

/// \param changed by chart
void Charts::remove(const std::vector<const Removal*>& removals, const std::vector<char>& changed,
  const ChartTrials::Result& flat)
{
  for (const Removal* one : removals)
  {
    this->Cut = this->cutAfter(*one);
  }
  std::vector<char> triangles;
  for (Index chart : this->ChartOf)
  {
    triangles.push_back(changed[chart]);
  }
  this->group(triangles);
  this->Lying = this->All.size() == 1 ? flat.corners : std::vector<FlatCorners>();
}

/// What becomes of the charts.
std::vector<OpenedPart> Charts::without(const Removal& removal) const
{
  const std::vector<char> cut = this->cutAfter(removal);
  std::vector<char> wanted(this->Mesh.triangleCount(), 0);
  for (Index chart : removal.charts)
  {
    for (Index t : this->All[chart].triangles)
    {
      wanted[t] = 1;
    }
  }
  std::vector<OpenedPart> parts;
  for (Index chart : removal.charts)
  {
    for (Index first : this->All[chart].triangles)
    {
      Indices triangles;
      if (wanted[first])
      {
        wanted[first] = 0;
        triangles.push_back(first);
      }
      for (std::size_t k = 0; k < triangles.size(); ++k)
      {
        for (Index h = 3 * triangles[k]; h < 3 * triangles[k] + 3; ++h)
        {
          const Index other = cut[h] || this->Mesh.twin(h) == none ? none : this->Mesh.twin(h) / 3;
          if (other != none && wanted[other])
          {
            wanted[other] = 0;
            triangles.push_back(other);
          }
        }
      }
      if (!triangles.empty())
      {
        std::sort(triangles.begin(), triangles.end());
        parts.push_back(openedPart(this->Mesh, triangles, cut));
      }
    }
  }
  return parts;
}

double Charts::forecastCost(const Removal& removal) const
{
  const double bound = this->Bound;
  const std::vector<OpenedPart> parts = this->without(removal);
  double cost = 0.0;
  for (const OpenedPart& part : parts)
  {
    const double strain = parts.size() == removal.left && this->isDisk(part)
      ? forecastStrain(part.mesh)
      : std::numeric_limits<double>::infinity();
    cost += strain > this->Options.hopelessShare * bound
      ? std::numeric_limits<double>::infinity()
      : (strain * strain + freeRise * bound * bound) * part.mesh.area();
  }
  return cost;
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
  const double own = this->priceOf(edges);
  for (std::size_t k = edges.size(); k-- > 0;)
  {
    edges.push_back(this->Images[edges[k]]);
  }
  for (Index& h : edges)
  {
    h = std::min(h, this->Mesh.twin(h));
  }
  sortUnique(edges);
  // The charts that become one with that at the first edge.
  Removal removal;
  removal.charts = { this->ChartOf[edges.front() / 3] };
  const auto has = [&](Index chart) {
    return std::find(removal.charts.begin(), removal.charts.end(), chart) != removal.charts.end();
  };
  std::vector<char> joined(edges.size(), 0);
  double price = 0.0;
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
      price += this->Prices[edges[k]];
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
  removal.saved = (fixedPrice / own + 1.0 / this->Size) * price;
  removal.edges = std::move(edges);
  return removal;
}

/// The charts beside a chart that get its triangles, each the nearest.
/// \param owner per triangle, where it is in the chart or in its image, who gets it; none before
Indices Charts::receivers(Index chart, Indices& owner) const
{
  const Index image = this->chartImage(chart);
  using Step = std::tuple<double, Index, Index>;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
  for (Index t : this->All[chart].triangles)
  {
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Index twin = this->Mesh.twin(h);
      const Index other = twin == none ? none : this->ChartOf[twin / 3];
      if (other != none && other != chart && other != image)
      {
        const Point3 middle =
          0.5 * (this->Mesh.point(this->Mesh.from(h)) + this->Mesh.point(this->Mesh.to(h)));
        queue.emplace((this->Mesh.centroid(t) - middle).norm(), t, other);
      }
    }
  }
  while (!queue.empty())
  {
    const auto [distance, t, to] = queue.top();
    queue.pop();
    if (owner[t] != none)
    {
      continue;
    }
    owner[t] = to;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      const Index next = this->Mesh.twin(h) == none ? none : this->Mesh.twin(h) / 3;
      if (next != none && this->ChartOf[next] == chart && owner[next] == none)
      {
        queue.emplace(
          distance + (this->Mesh.centroid(next) - this->Mesh.centroid(t)).norm(), next, to);
      }
    }
  }
  Indices all;
  for (Index t : this->All[chart].triangles)
  {
    const Index mirrored = this->imageOf(t);
    if (owner[t] == none)
    {
      return {};
    }
    if (mirrored < t && chart == image)
    {
      owner[t] = this->chartImage(owner[mirrored]);
    }
    owner[mirrored] = chart == image ? owner[mirrored] : this->chartImage(owner[t]);
    all.push_back(owner[t]);
  }
  sortUnique(all);
  return all;
}

/// A chart, and its image, whose triangles go to those beside it. \param owner see receivers()
Charts::Removal Charts::sharedOut(Index chart, Indices& owner) const
{
  Removal removal;
  const Index image = this->chartImage(chart);
  if (image < chart)
  {
    return removal;
  }
  removal.charts = this->receivers(chart, owner);
  if (removal.charts.size() < 2)
  {
    return removal; // one is a seam's matter
  }
  Indices images;
  for (Index c : removal.charts)
  {
    images.push_back(this->chartImage(c));
  }
  const bool both = image != chart && std::any_of(images.begin(), images.end(), [&](Index c) {
    return std::find(removal.charts.begin(), removal.charts.end(), c) != removal.charts.end();
  });
  removal.left = removal.charts.size();
  if (both)
  {
    removal.charts.insert(removal.charts.end(), images.begin(), images.end());
    sortUnique(removal.charts);
    removal.left = removal.charts.size();
    removal.charts.push_back(image);
  }
  removal.charts.push_back(chart);
  const auto ownerOf = [&](Index t) { return owner[t] == none ? this->ChartOf[t] : owner[t]; };
  double saved = 0.0;
  for (Index c : { chart, image })
  {
    for (Index t : c == image && image == chart && c != chart ? Indices{} : this->All[c].triangles)
    {
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index twin = this->Mesh.twin(h);
        const bool cut = twin != none && ownerOf(t) != ownerOf(twin / 3);
        if (twin == none || cut == (this->Cut[h] != 0))
        {
          continue;
        }
        (cut ? removal.opened : removal.edges).push_back(std::min(h, twin));
      }
    }
  }
  for (Indices* edges : { &removal.edges, &removal.opened })
  {
    sortUnique(*edges);
    saved += (edges == &removal.opened ? -1.0 : 1.0) * this->priceOf(*edges);
  }
  const double pair = image == chart ? 1.0 : 2.0;
  removal.saved = (both ? 2.0 : 1.0) * (cutPrice + saved / pair / this->Size);
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

/// Whether an arc runs across the mirror plane.
bool Charts::ownImage(const CutArc& arc) const
{
  const Index image = this->Images[arc.edges.front()];
  return arc.edges.size() > 1 && std::any_of(arc.edges.begin() + 1, arc.edges.end(), [&](Index h) {
    return h == image || this->Mesh.twin(h) == image;
  });
}

double Charts::priceOf(const Indices& edges) const
{
  return std::accumulate(
    edges.begin(), edges.end(), 0.0, [this](double sum, Index h) { return sum + this->Prices[h]; });
}

/// The edges of an arc from an end on, about a share of it. None where no dart is left.
Indices Charts::partOf(const CutArc& arc, bool front, double share) const
{
  const double whole = std::accumulate(arc.edges.begin(), arc.edges.end(), 0.0,
    [this](double length, Index h) { return length + this->Mesh.length(h); });
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
  return whole - sum < minCutLength * this->Size ? Indices{} : part;
}
}
