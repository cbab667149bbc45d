// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternOptionTable.h"

#include "Formats/FileOptions.h"
#include "Options/OptionRows.h"

#include <utility>

namespace flattening::pattern
{
namespace
{
using Table =
  OptionRows<PatternOption, FileOptions, &PatternOption::setIn, &PatternOption::valueIn>;
using All = FileOptions;

constexpr double largestLength = 1e6;
constexpr double largestNumber = 1e6;

/// A length with the slider of its widgets.
template <class Access>
OptionRow addLength(
  Table& table, const char* property, double low, double high, const Access& access)
{
  return table.add(property, access).range(0.0, largestLength).slider(low, high).form("MM");
}

/// Lengths of single curves.
OptionRow addCurveLengths(
  Table& table, const char* property, const char* spelling, const char* argument)
{
  return table.text(property, OptionType::List)
    .spelled(spelling, argument)
    .range(0.0, largestLength)
    .form("NAME=MM");
}

void addDrawing(Table& table)
{
  table.group(OptionOwner::Pattern, "Drawing");
  addLength(table, "Allowance", -1.0, 50.0, [](All& all) { return &all.pattern.allowance; })
    .label("Seam Allowance")
    .automatic("10, sheets 0")
    .help("Seam allowance; by default 10, and 0 of a material whose edges do not fray.");
  addCurveLengths(table, "CurveAllowances", "allowance", "curve_allowances")
    .help("Seam allowance along one curve, or along 'boundary'; NAME:2=MM on the side of piece 2 "
          "alone, as for an overlap.");
  addLength(table, "NotchSpacing", -1.0, 500.0, [](All& all) { return &all.pattern.notchSpacing; })
    .label("Notches Every")
    .automatic("by size")
    .help("Distance of notches along seams and darts (by default about a sixth of the largest "
          "piece). It is measured on the surface from their start; shorter seams and darts have a "
          "notch in the middle; 0: only at the mouths of darts.");
  addCurveLengths(table, "CurveNotches", "notch", "curve_notches")
    .help("A notch at this distance from the start of a curve. It replaces those by notch spacing "
          "on a seam, a dart or an edge.");
  table.text("DoubleNotches", OptionType::List)
    .spelled("double-notch", "double_notches")
    .form("NAME")
    .help("A curve whose notches are double, as at the back. Two marks 6.35 mm apart.");
  table.add("CutDartsOut", [](All& all) { return &all.pattern.cutDartsOut; })
    .help("Cut darts out along their seam allowance instead of folding them.");
  addLength(table, "DartTip", 0.0, 50.0, [](All& all) { return &all.pattern.dartTip; })
    .label("Dart Tips Drawn Back")
    .help(
      "How far folded darts end before their tips. Their legs are shorter then; at most half of "
      "a dart's depth.");
  addCurveLengths(table, "CurveDartTips", "dart-tip", "curve_dart_tips")
    .help("How far one dart ends before its tip.");
  table.add("CutOnFold", [](All& all) { return &all.pattern.cutOnFold; })
    .label("Halves to Cut on the Fold")
    .spelled("fold symmetric", "cut_on_fold")
    .help("Draw a half of each symmetric piece, to be cut on the fold of the cloth.");
  table.text("Folds", OptionType::List)
    .spelled("fold", "folds")
    .form("NAME")
    .help("A curve along which pieces are cut on the fold of the cloth: inside, where a half is "
          "drawn of a piece that must be symmetric about it, or on the border of a piece that is a "
          "half.");
  table.add("CutPairs", [](All& all) { return &all.pattern.pairs; })
    .label("One of Mirrored Pairs")
    .spelled("pairs", "cut_pairs")
    .help("Of two pieces that are mirror images draw the first. It is cut in pairs of which one is "
          "turned over.");
  table.add("FairTolerance", [](All& all) { return &all.pattern.fairTolerance; })
    .label("Smooth Outlines Within")
    .spelled("smooth", "fair")
    .range(0.0, 100.0)
    .slider(0.0, 5.0)
    .form("MM")
    .help("Draw borders and curves as smooth splines at most this far from the mesh. They keep "
          "their lengths and are straight where nearly so; 0: raw, as the mesh has them.");
  addCurveLengths(table, "CurveFairTolerances", "smooth", "curve_fairs")
    .range(0.0, 100.0)
    .help("The same distance along one curve, or along 'boundary'.");
  table.add("Quantity", [](All& all) { return &all.pattern.quantity; })
    .range(1.0, largestNumber)
    .slider(1.0, 100.0)
    .form("N")
    .help("How many of each piece are cut.");
  table.text("PieceNames", OptionType::List)
    .spelled("piece", "piece_names")
    .form("NAME")
    .help("Names of the pieces in their order.");
  table.text("PieceQuantities", OptionType::List)
    .spelled("piece", "piece_quantities")
    .range(1.0, largestNumber)
    .form("N")
    .help("How many of each piece are cut, in their order.");
  table.add("PatternName", [](All& all) { return &all.pattern.name; })
    .spelled("name", "name")
    .form("NAME")
    .help("Name of the pattern, written on each piece.");
  table.add("PatternSize", [](All& all) { return &all.pattern.size; })
    .label("Size")
    .spelled("size", "size")
    .form("NAME")
    .help("Size that the pattern is for; empty: none is written.");
}

void addDetails(Table& table)
{
  table.group(OptionOwner::Pattern, "Details");
  table.add("UpAxis", [](All& all) { return &all.pattern.up; })
    .spelled("up", "up")
    .words(
      { { "auto", "Automatic" }, { "x", "X" }, { "y", "Y" }, { "z", "Z" }, { "none", "None" } })
    .expert()
    .help("The axis of the surface that points up in each piece, with the grain along it. Pieces "
          "with a grain of their own keep that; auto: y or z, along which the surface is larger; "
          "none: no piece is turned.");
  table.add("JoinMarks", [](All& all) { return &all.pattern.joinMarks; })
    .label("Marks of Joins")
    .off("No letters along the two sides of what is sewn together.")
    .help("Mark both sides of each stretch that is sewn to another with the same letters, in the "
          "middle and, where there is room, near both ends, and list them in a PDF.");
  table.add("NotchCorners", [](All& all) { return &all.pattern.notchCorners; })
    .label("Notches at Corners")
    .help("Notch the cut line at corners, where the extended sew lines meet it.");
  table.add("NotchCurveEnds", [](All& all) { return &all.pattern.notchCurveEnds; })
    .label("Notches at Ends of Curves")
    .help("Notch the border where feature curves and edges end on it, and opposite on what is sewn "
          "to it.");
  addLength(table, "NotchLength", 0.0, 20.0, [](All& all) { return &all.pattern.notchLength; })
    .expert()
    .help("Length of a notch.");
  table.add("MitreLimit", [](All& all) { return &all.pattern.mitreLimit; })
    .range(1.0, 100.0)
    .slider(1.0, 10.0)
    .expert()
    .help("Longest miter of a corner, as a multiple of the allowance.");
  const auto addCompensation = [&table](const char* property, auto access, const char* text) {
    table.add(property, access)
      .range(-20.0, 20.0)
      .slider(-5.0, 5.0)
      .form("PERCENT")
      .expert()
      .help(text);
  };
  addCompensation(
    "WarpCompensation", [](All& all) { return &all.pattern.warpCompensation; },
    "Draw pieces longer along their grain by this many per cent, below 0 shorter: against "
    "shrinkage, or for cloth under tension.");
  addCompensation(
    "WeftCompensation", [](All& all) { return &all.pattern.weftCompensation; },
    "The same across the grain.");
  addLength(table, "Thickness", 0.0, 50.0, [](All& all) { return &all.pattern.thickness; })
    .spelled("sheet-thickness", "thickness")
    .expert()
    .help("Thickness of the material. The tables of joins and seams then have the bevel of both "
          "sides, half of the bend, and how far it goes back over the thickness.");
  addLength(table, "GlueTab", 0.0, 50.0, [](All& all) { return &all.pattern.glueTab; })
    .spelled("glue-tabs", "glue_tab")
    .help("Width of tabs to glue, with slanted ends, on the first side of each join; 0: none.");
  table.add("Symmetrize", [](All& all) { return &all.pattern.symmetrize; })
    .label("Symmetric Outlines")
    .help("Draw the outline of each piece that is symmetric to 0.5 mm as exactly its own mirror "
          "image; sides whose lengths differ by up to 0.1 mm get their mean.");
}

void addFormats(Table& table)
{
  table.group(OptionOwner::Pattern, "Cloth");
  table.add("FabricWidth", [](All& all) { return &all.fabric.width; })
    .label("Cloth Width")
    .spelled("roll-width", "fabric_width")
    .range(0.0, 1e5)
    .slider(0.0, 3000.0)
    .form("MM")
    .help("SVG, PDF and HPGL: lay all copies of all pieces on cloth of this width, their grain "
          "along it, as short as a search finds it; 0: pieces in rows.");
  table.add("FabricNap", [](All& all) { return &all.fabric.nap; })
    .label("Cloth Has a Nap")
    .spelled("nap", "nap")
    .help("The cloth has an up and a down: no piece is turned by half a turn.");
  table.add("FabricGap", [](All& all) { return &all.fabric.gap; })
    .label("Gap on Cloth")
    .spelled("gap", "fabric_gap")
    .range(0.0, 1000.0)
    .slider(0.0, 100.0)
    .form("MM")
    .expert()
    .help("Least distance of pieces on the cloth.");

  table.group(OptionOwner::Pattern, "PDF");
  table.add("Paper", [](All& all) { return &all.pages.paper; })
    .words({ { "A4", "A4" }, { "letter", "Letter" }, { "A3", "A3" }, { "A0", "A0" },
      { "sheet", "Sheet" } })
    .form("PAPER")
    .help("Paper of a PDF: A4, letter, A3, A0, sheet (one page as large as the pattern).");
  table.add("WalkTable", [](All& all) { return &all.walkTable; })
    .label("Table of Seams")
    .spelled("seam-table", "walk_table")
    .help("Append the lengths of both sides of seams to a PDF, from notch to notch.");
  table.add("PageOverlap", [](All& all) { return &all.pages.overlap; })
    .range(0.0, 50.0)
    .form("MM")
    .expert()
    .help("How far pages of a PDF overlap.");
  table.add("MaximumPages", [](All& all) { return &all.pages.maximumPages; })
    .range(1.0, 1e5)
    .slider(1.0, 1000.0)
    .form("N")
    .expert()
    .help("Most pages of a PDF; with more the unit is likely wrong.");

  table.group(OptionOwner::Pattern, "SVG");
  table.add("LaserColors", [](All& all) { return &all.laserColors; })
    .label("Colors for Lasers")
    .spelled("style laser", "laser_colors")
    .help("Draw an SVG in thin lines with a color for each role, as laser cutters need it.");

  table.group(OptionOwner::Pattern, "DXF");
  table.add("CutterStyle", [](All& all) { return &all.cutterStyle; })
    .label("For Cutting Machines")
    .spelled("style cutter", "cutter_style")
    .help("Draw a DXF for cutting machines: layers CUT, MARK and TEXT, each line once, with arcs.");
}
}

const std::vector<PatternOption>& patternOptionTable()
{
  static const std::vector<PatternOption> rows = [] {
    Table table;
    addDrawing(table);
    addDetails(table);
    addFormats(table);
    return std::move(table.Rows);
  }();
  return rows;
}

std::vector<const Option*> patternOptions()
{
  std::vector<const Option*> options;
  for (const PatternOption& option : patternOptionTable())
  {
    options.push_back(&option);
  }
  return options;
}

void setOptions(const OptionValues& values, FileOptions& options)
{
  for (const PatternOption& option : patternOptionTable())
  {
    if (option.setIn)
    {
      option.setIn(options, values[option.property]);
    }
  }
}
}
