// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/ChartClusters.h"
#include "Suggestion/ChartTrials.h"
#include "Suggestion/CutArcs.h"

#include <functional>
#include <limits>
#include <set>

namespace flattening
{
struct ChartOptions
{
  /// The strain, on 95 % of a chart's area, that is good enough; positive.
  double bound = 0.05;
  bool darts = true; ///< whether seams may end inside
  bool holes = true; ///< whether charts may surround holes of the surface
  Index pieces = 0;  ///< no fewer charts; 0: as few as the bound takes
  /// With more cuts charts are not parted again.
  double maxCuts = std::numeric_limits<double>::infinity();
  /// A chart whose forecast is more than this many times the bound is not flattened: of 8,000
  /// merged charts of animals and parts of machines 0.3 % kept the bound from there on.
  double hopelessShare = 1.5;
  /// Whether a mirror plane is kept to where its two sides differ too much to be cut alike.
  bool mirrorKept = false;
  FlatteningOptions flattening;
};

/// A mesh parted into charts by cut edges, which may be mirror images of each other.
class Charts
{
public:
  /// All must outlive it. \param cut per half-edge \param images per half-edge that of the mirror
  /// image; its own id where there is no mirror \param size sqrt(area / pi) of the whole surface
  Charts(const TriangleMesh& mesh, std::vector<char> cut, Indices images,
    const ChartOptions& options, double size, ChartTrials& trials);

  /// By triangle, whether its chart keeps the bound.
  std::vector<char> keeping(TrialBudget& budget, const Execution& execution);
  /// Divides charts that do not keep the bound until all do: the forecast by which they were chosen
  /// does not know of overlaps.
  void divide(TrialBudget& budget, const Execution& execution);
  /// Sews whole seams as long as charts keep the bound. \pre divide()
  /// \param sharing whether charts may be shared out among those beside them as well, with seams
  /// along edges
  void merge(bool sharing, TrialBudget& budget, const Execution& execution);
  /// As merge(), with larger bounds as long as there are more charts than wanted. \pre divide()
  /// \return the bound of all charts
  double mergeToFewest(TrialBudget& budget, const Execution& execution);
  /// Sews seams from an end on, and darts from their tips. \pre divide()
  void shorten(TrialBudget& budget, const Execution& execution);

  std::vector<CutArc> arcs(bool opened = true) const
  {
    return cutArcs(this->Mesh, this->Cut, this->HoleOf, opened);
  }
  /// By half-edge.
  const std::vector<char>& cut() const { return this->Cut; }

private:
  struct Chart
  {
    Indices triangles;
    bool keeps = false;
    Index version = 0; ///< another after each change
  };
  /// Cut edges that are sewn, and others that are cut in their place, with their images.
  struct Removal
  {
    Indices edges;
    Indices opened;
    Indices charts;       ///< that change, but for those that are images of others
    std::size_t left = 1; ///< charts that come of these
    double saved = 0.0;
  };
  struct Candidate
  {
    Removal removal;
    double cost = 0.0; ///< by the forecast; infinite where the chart cannot keep the bound
    bool tried = false;
    bool keeps = false;
  };

  void group(const std::vector<char>& changed);
  void number(TrialBudget& budget, const Execution& execution);
  void divideOnce(double bound);
  void eliminate(const std::function<void(const std::vector<CutArc>&, std::vector<Removal>&)>& list,
    TrialBudget& budget, const Execution& execution);
  bool removeTogether(
    const std::vector<Candidate*>& order, TrialBudget& budget, const Execution& execution);
  std::vector<ChartTrials::Result> tryWithout(
    const std::vector<const Removal*>& removals, TrialBudget& budget, const Execution& execution);
  bool removeFirst(
    const std::vector<Candidate*>& order, TrialBudget& budget, const Execution& execution);
  std::vector<char> cutAfter(const Removal& removal) const;
  void remove(const std::vector<const Removal*>& removals, const std::vector<char>& changed,
    const ChartTrials::Result& flat);
  Indices chartsBeside(const Removal& removal) const;
  std::vector<OpenedPart> without(const Removal& removal) const;
  bool worthIt(
    const Removal& removal, double waste, TrialBudget& budget, const Execution& execution);
  double forecastCost(const Removal& removal) const;
  bool isDisk(const OpenedPart& part) const;
  Removal removalOf(Indices edges, double fixedPrice) const;
  Removal sharedOut(Index chart, Indices& owner) const;
  Indices receivers(Index chart, Indices& owner) const;
  Index imageOf(Index triangle) const { return this->Images[3 * triangle] / 3; }
  Index chartImage(Index chart) const
  {
    return this->ChartOf[this->imageOf(this->All[chart].triangles.front())];
  }
  Indices keyOf(const Removal& removal) const;
  bool ownImage(const CutArc& arc) const;
  double priceOf(const Indices& edges) const;
  Indices partOf(const CutArc& arc, bool front, double share) const;

  const TriangleMesh& Mesh;
  std::vector<char> Cut;
  Indices Images;
  const ChartOptions& Options;
  double Bound;
  Index Fewest; ///< charts
  double Size;
  ChartTrials& Trials;
  Indices HoleOf; ///< by vertex
  std::vector<double>
    Prices;        ///< by half-edge, of a seam along it: its length, less at a sharp edge
  Indices ChartOf; ///< by triangle
  std::vector<Chart> All;
  Index Versions = 0;
  std::set<Indices> Needed;       ///< of a single piece, which it does not keep the bound without
  std::vector<FlatCorners> Lying; ///< by triangle, of a single chart, where it is known
  std::size_t Together = 1;       ///< cuts inside one chart that are sewn at once
};
}
