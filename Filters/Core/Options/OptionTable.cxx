// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionTable.h"

#include "Options/OptionRows.h"
#include "Options/OptionStructures.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>

namespace flattening
{
namespace
{
constexpr double unlimited = std::numeric_limits<double>::max();

/// By OptionOwner.
constexpr std::array<const char*, 8> classNames{ "vtkFeatureCurveAlgorithm",
  "vtkFlatPieceAlgorithm", "vtkWireWarpingFilter", "vtkFeatureCurveSuggestion",
  "vtkMakeFlattenable", "vtkLeastSquaresConformalFilter", "vtkSewnShape", "vtkPatternWriter" };

using Table = OptionRows<Option, OptionStructures, &Option::set>;
using All = OptionStructures;

// What several options have an effect with.
OptionCondition keepsLengths()
{
  return { "Scheme", { "progressive", "global", "isometric" } };
}
OptionCondition isometric()
{
  return { "Scheme", { "isometric" } };
}
OptionCondition exact()
{
  return { "BoundaryMode", { "exact" } };
}

void addCurves(Table& table)
{
  table.group(OptionOwner::Curves, "Surface and Curves");
  table.add("CoincidentPoints", [](All& all) { return &all.coincidentPoints; })
    .words({ { "automatic", "Automatic" }, { "join", "Join" }, { "keep", "Keep" } })
    .expert()
    .help(
      "Points of the surface with equal coordinates: join makes them one, keep does not, automatic "
      "joins where hardly any two triangles share a point, as in files of separate triangles.");
  table.add("HealSurface", [](All& all) { return &all.healSurface; })
    .spelled("heal", "heal")
    .off("Report defects of the surface as errors instead of healing them.")
    .help("Heal defects of the surface where it is clear how, with a warning for each kind: join "
          "points within a millionth of the edges there, remove triangles without area, doubled "
          "triangles and fins, separate edges of more than two triangles, double points in which "
          "parts touch, leave out parts below 0.1 % of the largest one's area.");
  table.add("SplitTriangles", [](All& all) { return &all.imprint.split; })
    .expert()
    .off("Report a curve that does not run along mesh edges as an error instead of splitting "
         "triangles.")
    .help("Split triangles where a curve does not run along mesh edges; off: such a curve is an "
          "error.");
  table.add("ImprintTolerance", [](All& all) { return &all.imprint.tolerance; })
    .spelled("curve-distance", "imprint_tolerance")
    .range(0.0, 1.0)
    .expert()
    .help("Greatest distance of a curve from the surface, as a fraction of the diagonal of the "
          "surface's bounding box.");
  table.add("SnapTolerance", [](All& all) { return &all.imprint.snap; })
    .range(0.0, 0.5)
    .expert()
    .help("Points and crossings of curves nearer than this to a vertex or an edge move onto it. A "
          "fraction of the mean edge length or, where it is shorter, of the longest edge there.");
}

void addMethod(Table& table)
{
  table.group(OptionOwner::Warping, "Method");
  table.add("Scheme", [](All& all) { return &all.flattening.scheme; })
    .words({ { "progressive", "Progressive" }, { "global", "Global" }, { "isometric", "Isometric" },
      { "lscm", "" } })
    .help(
      "How the wires get their shape: isometric (wires and interior together, which distorts "
      "least), global (all angles together, equation 13 of the paper), progressive (wire-patch by "
      "wire-patch, Algorithm 2), lscm (least squares conformal, for comparison: keeps no "
      "length).");
  table.add("BoundaryMode", [](All& all) { return &all.flattening.boundary; })
    .spelled("boundary")
    .words({ { "exact", "Exact" }, { "free", "Free" } })
    .where(isometric())
    .help("Which lengths are kept: exact (those of the boundary, of the sides of cuts and of all "
          "curves), or free (those of accessory and key curves alone, including such curves along "
          "the boundary, so that the surface distorts least).");
  table.add("PreventOverlap", [](All& all) { return &all.flattening.preventOverlap; })
    .spelled("no-overlap", "prevent_overlap")
    .where(isometric())
    .where({ "BoundaryMode", { "free" } })
    .where({ "Material", { "", "isotropic" } })
    .help("Keep a free boundary from crossing itself, where the piece would overlap, which costs "
          "distortion; off: it overlaps, with a warning.");
  table.text("WeightArray")
    .spelled("weights")
    .form("ARRAY")
    .where(isometric())
    .help("Cell array of the surface with the weight of distortion there, from 0; only ratios "
          "count. The isometric scheme distorts less where it is high, and cuts are proposed for "
          "there.");
  table.add("Interior", [](All& all) { return &all.flattening.interior.method; })
    .words({ { "laplacian", "Laplacian" }, { "relaxation", "Relaxation" },
      { "arap", "AsRigidAsPossible" } })
    .where(keepsLengths())
    .where(exact())
    .help("How points between wires are placed: arap (as rigid as possible), laplacian (Eq. 11), "
          "relaxation (the paper's iteration for it, Eq. 12). The isometric scheme only starts "
          "from that result.");
  table.add("ReleaseKeys", [](All& all) { return &all.flattening.releaseKeys; })
    .spelled("no-keys", "release_keys")
    .where(keepsLengths())
    .help("Treat key curves as accessory curves: their length is kept, their shape is free.");
  table.add("DartLegs", [](All& all) { return &all.flattening.dartLegs; })
    .words({ { "free", "Free" }, { "straight", "Straight" }, { "mirrored", "Mirrored" } })
    .byDefault("mirrored") // as darts are sewn, leg on leg
    .where(keepsLengths())
    .where(exact())
    .help("How the legs of a dart lie: free (as the piece distorts least; they fit sewn, but "
          "folded may miss each other), straight, or mirrored (both the mean of free ones). "
          "Straight and mirrored legs fold onto each other exactly, which costs distortion.");
  table.add("Solver", [](All& all) { return &all.flattening.angles.method; })
    .words({ { "newton", "Newton" }, { "sequential", "Sequential" } })
    .where(keepsLengths())
    .where(exact())
    .expert()
    .help("How the angles are solved for: newton (exact steps) or sequential (the paper's "
          "sequential linearly constrained programming, Eq. 15). The isometric scheme only starts "
          "from that solution.");
  table.add("ReleaseTrials", [](All& all) { return &all.flattening.tryReleases; })
    .where({ "Scheme", { "global", "isometric" } })
    .where(exact())
    .expert()
    .off("Rank the curves to release by their sensitivity alone, without trial flattenings.")
    .help("Where a piece or its wires' angles change much, try what releasing a curve would "
          "improve: up to six more flattenings of the piece, about two seconds by the isometric "
          "scheme; off: curves are ranked by their sensitivity alone.");
  const OptionCondition withoutThreads{ "Material", { "", "isotropic" } };
  table.add("DistortionEnergy", [](All& all) { return &all.flattening.isometric.energy.kind; })
    .spelled("energy")
    .words(
      { { "rigid", "Rigid" }, { "dirichlet", "SymmetricDirichlet" }, { "automatic", "Automatic" } })
    .byDefault("automatic")
    .where(isometric())
    .where(withoutThreads)
    .expert()
    .help("What deforming the sheet costs: rigid (as rigid as possible), dirichlet (symmetric "
          "Dirichlet, which forbids flipped triangles), or automatic (dirichlet where the boundary "
          "is free, else rigid).");
  table.add("AreaBias", [](All& all) { return &all.flattening.isometric.energy.bias; })
    .range(-0.99, 0.99)
    .where(isometric())
    .where(withoutThreads)
    .where({ "DistortionEnergy", { "automatic", "rigid" } })
    .expert()
    .help("Above 0 a change of area costs more than one of angle (stiff sheet), below 0 less "
          "(stretchy sheet).");
  table.add("AngleWeight", [](All& all) { return &all.flattening.isometric.angleWeight; })
    .range(0.0, 100.0)
    .where(isometric())
    .expert()
    .help("Weight of the wires' bending relative to the sheet's distortion: the larger, the nearer "
          "their angles are to those on the surface; 0 lets wires buckle.");
}

void addEase(Table& table)
{
  table.group(OptionOwner::Warping, "Ease");
  table.text("CurveTolerances", OptionType::List)
    .spelled("tolerance")
    .form("NAME=FRACTION")
    .where(keepsLengths())
    .help("Make a curve elastic: its length may change by up to this fraction, from 0 to below 1; "
          "boundary as NAME: each stretch of the boundary between ends of other wires.");
  table.text("CurveEases", OptionType::List)
    .spelled("ease")
    .form("NAME[:PIECE]=PERCENT%")
    .where(keepsLengths())
    .help(
      "Make a seam or a named edge longer in one piece (numbered from 1) than on the surface and "
      "than what it is sewn to, or below 0 shorter. The curve needs at least this tolerance.");
}

void addPieces(Table& table)
{
  table.group(OptionOwner::Pieces, "Pieces");
  table.add("SkipClosed", [](All& all) { return &all.flattening.skipClosed; })
    .help("Leave out pieces that cannot be laid flat, since they have no boundary or have handles, "
          "and flatten the others, with a warning; off: such a surface is an error.");
  table.add("Arrange", [](All& all) { return &all.flattening.arrange; })
    .off("Leave pieces where their first wire edge put them instead of upright, side by side.")
    .help("Turn pieces upright (the first key curve, else the long side, along y) and lay them "
          "side by side; off: each stays where its first wire edge put it.");
  table.add("Spacing", [](All& all) { return &all.flattening.spacing; })
    .range(0.0, 1e6)
    .slider(0.0, 1.0)
    .where({ "Arrange", {} })
    .help("Space between the bounding boxes of pieces, as a fraction of the largest side of one.");
  table.add("CloseCuts", [](All& all) { return &all.flattening.closeCuts; })
    .help("Close darts and other cuts where their sides would overlap, which costs distortion; "
          "off: they overlap, with a warning.");
  table.group(OptionOwner::Pieces, "Material");
  table.text("Material")
    .form("NAME|FILE")
    .help("What the pieces are cut from: the name of a known material, or a JSON file with its "
          "numbers. The isometric scheme keeps the strain of its threads small and within its "
          "limits; other schemes only measure it.");
  table.text("Grain", OptionType::List)
    .form("CURVE|DEGREES|free")
    .where({ "Material", {} })
    .help(
      "Direction of the warp in each piece: along a curve, or at NAME:DEGREES from it (of several "
      "the first that the piece has); at DEGREES from its first key curve, else from its long "
      "side; or free, where the material is strained least. Angles count counter-clockwise.");
}

void addSolver(Table& table)
{
  const OptionCondition rigid{ "Interior", { "arap" } };
  const OptionCondition relaxes{ "Interior", { "relaxation" } };
  const auto tolerance = [](OptionRow row) {
    return row.range(0.0, unlimited).slider(0.0, 1e-3).expert();
  };
  const auto count = [](OptionRow row, double least = 1.0) {
    return row.range(least, std::numeric_limits<int>::max()).slider(least, 1000.0).expert();
  };
  table.group(OptionOwner::Warping, "Solver");
  count(table.add(
          "MaximumIterations", [](All& all) { return &all.flattening.angles.maximumIterations; }))
    .where(keepsLengths())
    .where(exact())
    .help("Maximum iterations of the solver of the angles, per piece.");
  tolerance(
    table.add("ClosureTolerance", [](All& all) { return &all.flattening.angles.closureTolerance; }))
    .where(keepsLengths())
    .where(exact())
    .help("The solver stops when no loop of wires is open by more than this fraction of the "
          "perimeter.");
  tolerance(table.add("OptimalityTolerance",
              [](All& all) { return &all.flattening.angles.optimalityTolerance; }))
    .where(keepsLengths())
    .where(exact())
    .help("The solver stops when no entry of the gradient of the Lagrangian is larger than this.");
  count(table.add("IsometricMaximumIterations",
          [](All& all) { return &all.flattening.isometric.maximumIterations; }))
    .spelled("isometric-iterations")
    .where(isometric())
    .help("Maximum iterations of the isometric scheme.");
  tolerance(
    table.add("IsometricTolerance", [](All& all) { return &all.flattening.isometric.tolerance; }))
    .where(isometric())
    .help("The isometric scheme stops when the relative gradient of the Lagrangian is below this.");
  tolerance(table.add("RigidEnergyTolerance",
              [](All& all) { return &all.flattening.interior.energyTolerance; }))
    .spelled("rigid-tolerance")
    .where(keepsLengths())
    .where(exact())
    .where(rigid)
    .help("Interior arap stops when the energy falls by less than this fraction of itself.");
  count(table.add("RigidMaximumIterations",
          [](All& all) { return &all.flattening.interior.maximumRigidIterations; }))
    .spelled("rigid-iterations")
    .where(keepsLengths())
    .where(exact())
    .where(rigid)
    .help("Maximum iterations of interior arap.");
  table.add("RelaxationFactor", [](All& all) { return &all.flattening.interior.relaxation; })
    .within(0.0, 2.0)
    .slider(0.01, 1.99)
    .where(keepsLengths())
    .where(exact())
    .where(relaxes)
    .expert()
    .help("Factor tau of interior relaxation (Eq. 12).");
  tolerance(
    table.add("RelaxationMovement", [](All& all) { return &all.flattening.interior.movement; }))
    .slider(0.0, 0.1)
    .where(keepsLengths())
    .where(exact())
    .where(relaxes)
    .help("Interior relaxation stops when no point moves farther than this fraction of the mean "
          "wire edge.");
  count(table.add("RelaxationMinimumIterations",
          [](All& all) { return &all.flattening.interior.minimumIterations; }),
    0.0)
    .where(keepsLengths())
    .where(exact())
    .where(relaxes)
    .help("Minimum iterations of interior relaxation; more than the maximum is an error.");
  count(table.add("RelaxationMaximumIterations",
          [](All& all) { return &all.flattening.interior.maximumIterations; }))
    .where(keepsLengths())
    .where(exact())
    .where(relaxes)
    .help("Maximum iterations of interior relaxation.");
  tolerance(
    table.add("MaximumLengthError", [](All& all) { return &all.flattening.lengthTolerance; }))
    .slider(0.0, 1.0)
    .where(keepsLengths())
    .help("A relative error of a wire edge above this is a warning.");
}

void addSuggestion(Table& table)
{
  const OptionCondition cuts{ "SuggestedCuts", { "darts", "seams", "all", "gores" } };
  table.group(OptionOwner::Suggestion, "Suggestions");
  table.add("SuggestedCuts", [](All& all) { return &all.search.cuts; })
    .spelled("kind", "cuts")
    .words({ { "darts", "Darts" }, { "seams", "Seams" }, { "all", "DartsAndSeams" },
      { "lines", "Lines" }, { "gores", "Gores" } })
    .help("What is proposed: darts, seams, all (both), gores (equal seams of a round surface) or "
          "lines (no cuts, but center and grain lines, girths and style lines). Cuts that open a "
          "closed surface, a tube or a handle are proposed with darts, seams and all.");
  table.add("Bound", [](All& all) { return &all.search.bound; })
    .spelled("max-strain", "bound")
    .form("STRAIN")
    .range(0.0, 0.99)
    .where(cuts)
    .help("The strain that is good enough, on 95 % of each piece's area; 0: cut until the maximum "
          "number or length of cuts is reached, or no cut is worth its price.");
  table.add("MaximumCuts", [](All& all) { return &all.search.maximumCuts; })
    .range(0.0, std::numeric_limits<int>::max())
    .slider(0.0, 50.0)
    .where(cuts)
    .help("Maximum number of cuts, mirror images included; 0: as many as the bound needs.");
  table.add("MaximumCutLength", [](All& all) { return &all.search.maximumCutLength; })
    .spelled("max-length", "max_cut_length")
    .range(0.0, unlimited)
    .slider(0.0, 1000.0)
    .where(cuts)
    .help("Maximum length of all proposed cuts together, in the unit of the surface; 0: no limit.");
  table.add("MaximumWork", [](All& all) { return &all.search.maximumWork; })
    .range(0.0, unlimited)
    .slider(0.0, 1000.0)
    .where(cuts)
    .help("Maximum work of the search, in millions of steps on one triangle, each about half a "
          "second of one processor; the best cuts found by then are proposed; 0: no limit.");
  table.add("PieceCount", [](All& all) { return &all.search.pieces; })
    .spelled("pieces", "pieces")
    .range(0.0, std::numeric_limits<int>::max())
    .slider(0.0, 50.0)
    .where({ "SuggestedCuts", { "seams", "all", "gores" } })
    .help(
      "Approximate number of pieces into which seams divide the surface, with as little strain "
      "as that allows; 0: as few as the bound needs. 1 with a free boundary and all kinds of cuts: "
      "one piece, opened along a tree of cuts until it keeps the bound or comes near to it.");
  table.add("MaximumWidth", [](All& all) { return &all.search.maximumWidth; })
    .spelled("max-width", "max_width")
    .range(0.0, unlimited)
    .slider(0.0, 1000.0)
    .where(cuts)
    .help("Maximum width of each flat piece, measured in its narrowest direction, in the unit of "
          "the surface; seams that are straight in the plane divide wider pieces into strips of "
          "equal width; 0: no limit.");
  table.add("Symmetric", [](All& all) { return &all.search.symmetric; })
    .form("on|off|force|CURVE|PLANE")
    .help("Mirrored cuts: on (where the surface is its own mirror image within 3 %), off, force "
          "(across the best plane that there is), across the plane of a curve, or across a plane: "
          "x, y or z, x=0.2, or its normal and offset as 1,0,0,0.2.");
  table.text("Preferences", OptionType::List)
    .spelled("prefer")
    .form("NAME=WEIGHT")
    .where(cuts)
    .help("Preference weight of a curve as a place where cuts begin or end: their price is divided "
          "by it; 0 forbids it.");
}

void addOthers(Table& table)
{
  table.group(OptionOwner::Reshaping, "Moving the Surface");
  table.add("Bound", [](All& all) { return &all.reshaping.bound; })
    .spelled("max-strain", "bound")
    .form("STRAIN")
    .range(1e-6, 0.99)
    .help("The strain that is good enough, on 95 % of each piece's area.");
  table.text("KeptCurves", OptionType::List)
    .spelled("keep")
    .form("NAME")
    .help("A curve that stays where it is.");
  table.add("KeepBoundary", [](All& all) { return &all.reshaping.keepBoundary; })
    .off("Move the boundary as well.", "free-boundary")
    .help("Leave the boundary of the surface where it is.");
  table.add("OutsideBias", [](All& all) { return &all.reshaping.outsideBias; })
    .spelled("outward", "outside_bias")
    .range(0.0, 1.0)
    .help("How much the surface moves outwards, along the normals of the design, rather than "
          "inwards; 0: both alike, 1: no point moves inwards.");
  table.add("Thickness", [](All& all) { return &all.reshaping.thickness; })
    .range(0.0, 1.0)
    .expert()
    .help("Thickness of a plate that bends as the surface does while it moves, as a fraction of "
          "its size.");

  table.group(OptionOwner::Sewing, "Sewing Simulation");
  table.add("Test", [](All& all) { return &all.sewing.test; })
    .spelled("mode", "test")
    .words({ { "panel", "Panel" }, { "product", "Product" } })
    .help("What is held in place: panel (the boundary of each piece, where the design has it) or "
          "product (nothing: seams are shared, hems free).");
  table.add("Thickness", [](All& all) { return &all.sewing.thickness; })
    .range(0.0, 1.0)
    .help("Thickness of a plate that bends as the cloth does, as a fraction of the size of a "
          "piece.");
  table.add("AreaBias", [](All& all) { return &all.sewing.areaBias; })
    .range(-0.99, 0.99)
    .expert()
    .help("Above 0 a change of area costs the cloth more than one of angle, below 0 less.");
  table.add("MaximumIterations", [](All& all) { return &all.sewing.maximumIterations; })
    .spelled("sewing-iterations", "max_iterations")
    .range(1.0, std::numeric_limits<int>::max())
    .slider(1.0, 1000.0)
    .expert()
    .help("Maximum iterations until the cloth is at rest, per shape.");
  table.add("Pressure", [](All& all) { return &all.sewing.pressure; })
    .range(-1.0, 1.0)
    .help("Pressure behind the cloth, in units of its stiffness over its size; a product must be "
          "closed.");
  table.add("Gravity", [](All& all) { return &all.sewing.gravity; })
    .range(-1.0, 1.0)
    .form("X Y Z")
    .help("Weight of the cloth per area and its direction, in units of its stiffness over its "
          "size, such as 0 0 -0.0002 where z is up; a product needs a body to lie on.");
  table.text("Material")
    .form("NAME|FILE")
    .help(
      "What the cloth is made of, with its warp along y of the flat pieces: the name of a known "
      "material, or a JSON file; empty: an isotropic sheet.");
  table.add("SecondStart", [](All& all) { return &all.sewing.secondStart; })
    .expert()
    .off("Come to rest from one start alone, in half the time. Other shapes at rest are not looked "
         "for.",
      "once")
    .help("Come to rest from a second start as well, to find other shapes, in twice the time.");

  const OptionCondition conformal{ "Scheme", { "lscm" } };
  table.group(OptionOwner::Conformal, "Method");
  table.add("AreaNormalized", [](All& all) { return &all.flattening.conformal.areaNormalized; })
    .where(conformal)
    .expert()
    .off("Scheme lscm: let every triangle count by the square of its area.")
    .help("Scheme lscm: let every triangle count by its area; off: by the square of its area.");
  table.add("Pins", [](All& all) { return &all.flattening.conformal.pins; })
    .byFilter()
    .form("V0 V1")
    .where(conformal)
    .expert()
    .help("The two vertices that lscm pins, ids counted from 0; -1: the boundary vertices farthest "
          "apart.");
}
}

const std::vector<Option>& optionTable()
{
  static const std::vector<Option> rows = [] {
    Table table;
    addCurves(table);
    addPieces(table);
    addMethod(table);
    addEase(table);
    addSolver(table);
    addSuggestion(table);
    addOthers(table);
    return std::move(table.Rows);
  }();
  return rows;
}

const char* className(OptionOwner owner)
{
  return classNames[static_cast<std::size_t>(owner)];
}

std::optional<OptionOwner> ownerNamed(const std::string& name)
{
  const auto* const found = std::find(classNames.begin(), classNames.end(), name);
  return found == classNames.end()
    ? std::nullopt
    : std::make_optional(static_cast<OptionOwner>(found - classNames.begin()));
}

std::vector<const Option*> optionsOf(OptionOwner owner)
{
  std::set<OptionOwner> owners{ owner };
  if (owner == OptionOwner::Suggestion || owner == OptionOwner::Reshaping)
  {
    owners.insert(OptionOwner::Warping);
  }
  if (owners.count(OptionOwner::Warping) > 0)
  {
    owners.insert(OptionOwner::Conformal); // what programs have as a scheme
  }
  if (owner != OptionOwner::Sewing && owner != OptionOwner::Curves)
  {
    owners.insert({ OptionOwner::Curves, OptionOwner::Pieces });
  }
  std::vector<const Option*> options;
  for (const Option& option : optionTable())
  {
    if (owners.count(option.owner) > 0)
    {
      options.push_back(&option);
    }
  }
  return options;
}

const Option* findOption(OptionOwner owner, const std::string& property)
{
  const std::vector<const Option*> options = optionsOf(owner);
  const auto found = std::find_if(options.begin(), options.end(),
    [&property](const Option* option) { return option->property == property; });
  return found == options.end() ? nullptr : *found;
}
}
