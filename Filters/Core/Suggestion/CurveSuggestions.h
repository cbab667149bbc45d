// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Imprint/ImprintedSurface.h"
#include "Suggestion/SurfaceMirror.h"
#include "Surface/FeatureCurve.h"
#include "Surface/RegionWeights.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace flattening
{
/// What may be proposed.
enum class SuggestedCuts
{
  Darts,
  Seams,
  All,
  Lines, ///< no cuts: suggestLines()
  Gores, ///< seams between gores alone, see findGores()
};

/// In R = sqrt(area / pi) of the piece: what a cut costs beside its length, and how long it is at
/// least.
inline constexpr double cutPrice = 0.2;
inline constexpr double minCutLength = 0.12;

/// A strain above this multiple of the bound misses it by far.
inline constexpr double missedBy = 1.5;

/// All lengths are in units of R, except where said.
struct SearchOptions
{
  SuggestedCuts cuts = SuggestedCuts::All;
  /// The strain, on 95 % of each piece's area, that is good enough; 0: go on until cuts or length
  /// are used up, or no cut is worth its price.
  double bound = 0.05; // cloth gives as much
  /// Of all proposed cuts; 0: as many as the bound takes.
  Index maximumCuts = 0;
  /// Into how many pieces seams are to part the surface, with as little strain as that allows; 0:
  /// as few as the bound takes.
  Index pieces = 0;
  /// Of all proposed cuts together, in the surface's unit; 0: no limit.
  double maximumCutLength = 0.0;
  double cutLengthLimit() const
  {
    return this->maximumCutLength > 0.0 ? this->maximumCutLength
                                        : std::numeric_limits<double>::infinity();
  }
  /// Of each flat piece where it is narrowest, in the surface's unit, as of a roll of cloth; 0:
  /// any.
  double maximumWidth = 0.0;
  /// Which mirror plane is kept to, see readSymmetry().
  std::string symmetric = "on";
  /// Curves along which a cut may begin or end at another price: it is divided by the weight; 0
  /// forbids it.
  struct Preference
  {
    std::string curve;
    double weight = 1.0;
  };
  std::vector<Preference> preferences;
  /// What each cut costs beside its length.
  double fixedPrice = cutPrice;
  /// Real flattenings to choose each cut from, after the forecast has ranked them.
  Index trials = 24;
  /// Of all real flattenings, in millions of steps of an iteration on one triangle (see
  /// factorizationWork()), whatever the size of the surface. The best cuts that are
  /// found by then are proposed. 0: no limit.
  double maximumWork = 90.0;
};

struct SuggestionOptions
{
  SearchOptions search;
  /// Where distortion matters: cuts are chosen by energies and strains for which each triangle's
  /// area is multiplied by its weight. Keeps no mirror plane that does not mirror it as well. Of no
  /// effect on lines.
  RegionWeights weights;
  ImprintOptions imprint;
  /// As the flattening to come will use them.
  FlatteningOptions flattening;
};

/// A proposed cut or line. What is measured without it, or with it, is NaN where the surface cannot
/// be flattened so, as a closed one until it is cut.
struct SuggestedCurve
{
  Polyline curve;
  double length = 0.0;
  /// Drops of the mean of u^2 (see ScaleFactor) and of the rigid energy over the surface, by this
  /// cut after those before it; mirror images share one.
  double predictedGain = 0.0;
  double gain = 0.0;
  double opening = 0.0;         ///< of a dart's widest place, by the forecast
  double areaErrorBefore = 0.0; ///< mean change of area without it and those after it
  double areaErrorAfter = 0.0;
  double strainBefore = 0.0; ///< largest p95 strain of a piece without it and those after it
  double strainAfter = 0.0;
  bool sound = true;     ///< of a line that is left out: it is valid, but costs too much
  Index mirrorOf = none; ///< the proposal that it is the mirror image of
};

/// Whether any is the mirror image of another.
bool arePaired(const std::vector<SuggestedCurve>& cuts);

/// A cut along points.
SuggestedCurve proposedCut(Points3 points, CurveType type = CurveType::Seam, Index mirrorOf = none);

/// Why a search ended.
enum class SearchEnd
{
  BoundMet,
  CutsUsedUp,
  NothingHelps, ///< no cut that the limits allow is worth its price
  GivenUp,      ///< the bound is out of reach, see searchCuts()
  WorkUsedUp,
  Interrupted ///< by the caller
};

struct CurveSuggestions
{
  std::vector<SuggestedCurve> curves;
  /// Lines that were tried and cost too much.
  std::vector<SuggestedCurve> leftOut;
  std::optional<SurfaceMirror> mirror; ///< where some are mirror images of others
  double strainBefore = 0.0;           ///< largest p95 strain of a piece; NaN as in SuggestedCurve
  double strainAfter = 0.0;
  double rigidEnergyBefore = 0.0;
  double rigidEnergyAfter = 0.0;
  bool boundMet = false;
  double width = 0.0; ///< of the widest piece, where a maximum was given
  Index trials = 0;
  double work = 0.0; ///< of the trials, in the unit of SearchOptions::maximumWork
  /// Of the search whose cuts are proposed; WorkUsedUp where that ended any.
  SearchEnd end = SearchEnd::NothingHelps;
  double cutsNeeded = 0.0;            ///< where it was given up, see CutSet
  Point3 worstPlace = Point3::Zero(); ///< where the strain is largest that is left
  Status status;
};

/// The mirror that cuts are to keep to, by SearchOptions::symmetric; none where there is none.
/// Errors: InvalidOption (a text, or a plane that mirrors the surface too badly).
/// \param weights relative ones, which it has to mirror as well
Status findMirror(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SearchOptions& search, const RegionWeights& weights, const Execution& execution,
  std::optional<SurfaceMirror>& mirror);

/// Adds the images of the cuts from one on.
void addImages(std::vector<SuggestedCurve>& cuts, Index first, const SurfaceMirror& mirror);

/// A dart whose image is a seam becomes one.
void pairTypes(std::vector<SuggestedCurve>& cuts);

/// Numbers darts and seams in their order, beside the names of curves that there are.
void nameCuts(const std::vector<Polyline>& curves, std::vector<SuggestedCurve>& cuts);

/// Whether a proposed cut or line may have this name, such as "dart 3".
bool isProposedName(const std::string& name);

/// Errors: InvalidOption (a number out of its range, a preference for an unknown curve, weights as
/// checkWeights() says, a grain along curves of which none is known or may be proposed).
/// \param triangles how many the surface has
Status checkSuggestion(
  const SuggestionOptions& suggestion, Index triangles, const std::vector<Polyline>& curves);
}
