// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns.h"

#include "Base/LengthUnit.h"
#include "Base/Memory.h"
#include "Drawing/PatternBuilder.h"
#include "FlagWords.h"
#include "Flattening.h"
#include "Formats/PatternData.h"
#include "Input/StatusWords.h"
#include "InputError.h"
#include "Options.h"
#include "Outlines/DrawingSource.h"
#include "OutputFiles.h"
#include "PlainText.h"
#include "Progress.h"
#include "Report/FlatteningRun.h"
#include "Suggestion/CurveSuggestions.h"
#include "TableOptions.h"
#include "TextFile.h"
#include "TriangleList.h"
#include "Units.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <utility>

namespace wirewarp
{
namespace
{
namespace pattern = flattening::pattern;
using flattening::OptionValues;
using flattening::Status;
using pattern::NoteKind;

/// Of the surface's area, that of a pattern at least: half of symmetric pieces is drawn on a fold,
/// one of a pair, and cloth gives.
constexpr double leastShareDrawn = 0.2;

/// Hands entries NAME=MM on.
template <class Set>
void forCurves(const OptionValues& values, const char* property, const Set& set)
{
  for (const std::string& entry : values.list(property))
  {
    const auto [curve, length] = namedNumber(entry, *values.find(property));
    set(curve, length);
  }
}

pattern::FileOptions optionsOf(
  const PatternRequest& request, const std::string& surface, const std::string& unit)
{
  const OptionValues& values = request.values;
  pattern::FileOptions file;
  pattern::setOptions(values, file);
  pattern::PatternOptions& drawn = file.pattern;
  drawn.unit = flattening::unitNamed(unit);
  if (!values.isGiven("PatternName"))
  {
    drawn.name = std::filesystem::u8path(surface).stem().string();
  }
  drawn.size = request.size;
  const auto keepIn = [](std::map<std::string, double>& kept) {
    return [&kept](const std::string& curve, double length) { kept[curve] = length; };
  };
  forCurves(values, "CurveAllowances", keepIn(drawn.allowanceOfCurve));
  forCurves(values, "CurveDartTips", keepIn(drawn.dartTipOfCurve));
  forCurves(values, "CurveFairTolerances", keepIn(drawn.fairToleranceOfCurve));
  forCurves(values, "CurveNotches", [&drawn](const std::string& curve, double distance) {
    drawn.notchesOfCurve[curve].push_back(distance);
  });
  const std::vector<std::string>& doubled = values.list("DoubleNotches");
  drawn.doubleNotches = { doubled.begin(), doubled.end() };
  const std::vector<std::string>& folds = values.list("Folds");
  drawn.foldsAlong = { folds.begin(), folds.end() };
  for (const auto& [name, copies] : request.pieces)
  {
    drawn.pieceNames.push_back(name);
    drawn.pieceQuantities.push_back(copies);
  }
  return file;
}

bool isNews(NoteKind kind, const PatternRequest& request, bool quiet)
{
  const bool asked =
    request.values.isGiven("FairTolerance") || request.values.isGiven("CurveFairTolerances");
  switch (kind)
  {
    case NoteKind::Smoothed:
      return asked && !quiet;
    case NoteKind::LeftRough:
      return asked;
    case NoteKind::NotSmoothed:
      return asked || !quiet;
    case NoteKind::NotMirrored:
      return true;
    default:
      return !quiet;
  }
}

/// What was refused to be written to a path, in the command's words.
std::string refusalOf(const Status& status, const std::string& path)
{
  if (status.code == flattening::StatusCode::OutOfMemory)
  {
    throw std::bad_alloc();
  }
  // The file of that name is one beside the user's, whom nobody has told of it.
  const std::string& defect = status.message;
  const std::size_t at = defect.find(path + ' ');
  return messageOf(at == 0 ? defect.substr(path.size() + 1) : defect, remediesOf(status));
}

/// Whether only PDF files on pages are wanted, and their pages cannot hold the surface.
Status pagesFor(const Options& options, const flattening::DataSet& surface,
  const pattern::FileOptions& drawn, const std::string& unit)
{
  const std::vector<PatternFile>& files = options.pattern.files;
  const bool alone = !files.empty() && options.outputs.size() == files.size() &&
    std::all_of(files.begin(), files.end(),
      [](const PatternFile& file) { return file.format == pattern::FileFormat::Pdf; });
  if (!alone)
  {
    return {};
  }
  const TriangleList list = listTriangles(surface);
  double area = 0.0;
  for (const ListedTriangle& triangle : list.triangles)
  {
    const Point3& a = list.point(triangle.corners[0]);
    area +=
      0.5 * (list.point(triangle.corners[1]) - a).cross(list.point(triangle.corners[2]) - a).norm();
  }
  const double millimetres = millimetresOf(unit);
  return pattern::checkPages(leastShareDrawn * area * millimetres * millimetres, drawn.pages);
}
}

void checkPattern(const Options& options, const flattening::DataSet& surface,
  flattening::CurveInput curves, const flattening::OptionStructures& settings, Flattening& result)
{
  const PatternRequest& request = options.pattern;
  const pattern::FileOptions file = optionsOf(request, options.surface, result.unit);
  const pattern::PatternOptions& drawn = file.pattern;
  const std::set<std::string> named = pattern::curvesWithOptions(drawn);
  const auto refuse = [&result](const Status& status) {
    result.exitCode = InputRefused;
    result.status = flattening::statusName(status.code);
    result.message = refusalOf(status, "");
  };
  const Status pages = pagesFor(options, surface, file, result.unit);
  if (!pages.ok())
  {
    refuse(pages);
  }
  if (!pages.ok() || !request.any() || named.empty())
  {
    return;
  }
  flattening::CurvedSurface curved;
  flattening::FlatteningRun run(curved);
  if (!run.load(readTriangles(surface), std::move(curves), settings, {}, {}))
  {
    return; // the flattening says what is wrong
  }
  pattern::PatternSource source;
  const auto add = [&source](const std::string& name) {
    source.wires.emplace_back();
    source.wires.back().type = pattern::WireType::Accessory;
    source.wires.back().name = name;
  };
  for (const flattening::FeatureCurve& curve : curved.imprinted.curves)
  {
    add(curve.name);
  }
  const bool proposes = options.command == "cut" || options.command == "make";
  for (const std::string& name : named)
  {
    const std::string curve = pattern::curveSide(name).first;
    if (proposes && flattening::isProposedName(curve))
    {
      add(curve);
    }
  }
  const Status status = pattern::checkPatternOptions(source, drawn);
  if (!status.ok())
  {
    refuse(status);
  }
}

std::vector<std::string> addPatterns(const Options& options, Flattening& result, OutputFiles& files)
{
  const PatternRequest& request = options.pattern;
  std::vector<std::string> names;
  std::set<std::string> warnings;              // of all formats alike
  std::map<std::string, NoteKind> notes;       // with their kinds
  std::map<std::string, std::string> failures; // files by what is wrong with them
  pattern::FileOptions drawn = optionsOf(request, options.surface, result.unit);
  auto progress = std::make_optional<Progress>(options.quiet);
  pattern::FairCache fair(progress->execution(options.threads));
  const double fabricWidth = drawn.fabric.width;
  drawn.fair = &fair;
  drawn.grading = result.grading.get();
  pattern::PatternSource source;
  const Status read = request.any()
    ? pattern::readPattern(*result.flat, result.wires.get(), result.cut.get(), source)
    : Status();
  for (const PatternFile& file : request.files)
  {
    drawn.format = file.format;
    drawn.fabric.width = file.onCloth ? fabricWidth : 0.0;
    pattern::Pattern drawing;
    const std::string problem =
      files.add(std::filesystem::u8path(file.path), [&](const std::string& path) {
        const Status status = read.ok() ? flattening::withinMemory([&] {
          return pattern::writePattern(path, source, drawn, drawing);
        })
                                        : read;
        return status.ok() ? std::string() : refusalOf(status, path);
      });
    if (!problem.empty())
    {
      std::string& failed = failures[problem];
      failed += (failed.empty() ? "" : ", ") + file.path;
      continue;
    }
    for (const pattern::PatternPiece& piece : drawing.pieces)
    {
      warnings.insert(piece.warnings.begin(), piece.warnings.end());
      for (const pattern::PatternNote& note : piece.notes)
      {
        notes.emplace(note.text, note.kind);
      }
    }
    names.push_back(file.path);
    if (file.onCloth && drawing.fabric)
    {
      result.layWidth = fabricWidth;
      result.layLength = drawing.fabric->length;
      result.layEfficiency = drawing.fabric->efficiency;
    }
  }
  progress.reset();
  for (const auto& [problem, failed] : failures)
  {
    result.unwritten.push_back(failed);
    result.unwritten.back().append(": ").append(problem);
  }
  for (const std::string& warning : warnings)
  {
    std::cerr << messageLine(
      "warning", warning + "; draw it as 'straight NAME v0 v1', or with KeyShape 1");
  }
  for (const auto& [note, kind] : notes)
  {
    result.patternNotes.push_back(note);
    if (isNews(kind, request, options.quiet || options.command == "make"))
    {
      std::cerr << messageLine("note", note);
    }
  }
  return names;
}

namespace
{
/// NAME, NAME:QUANTITY or :QUANTITY of the pieces in their order.
void addPieces(CLI::App& app, PatternRequest& request)
{
  app
    .add_option_function<std::vector<std::string>>(
      "--piece",
      [&request](const std::vector<std::string>& entries) {
        for (const std::string& entry : entries)
        {
          const std::size_t colon = entry.rfind(':');
          long long quantity = 0;
          const bool counted =
            colon != std::string::npos && parseInteger(entry.substr(colon + 1), quantity);
          const flattening::Option& copies = *request.values.find("PieceQuantities");
          if (counted && !isValid(copies, static_cast<double>(quantity)))
          {
            throw CLI::ValidationError(
              "--piece", inQuotes(entry) + " is not NAME:COPIES with copies in " + rangeOf(copies));
          }
          request.pieces.emplace_back(
            counted ? entry.substr(0, colon) : entry, static_cast<int>(quantity));
        }
      },
      "Name of a piece and how many are cut, from piece 1 on; repeat it for the next")
    ->type_name("NAME[:COPIES]")
    ->allow_extra_args(false);
}
}

void addDrawing(CLI::App& app, PatternRequest& request)
{
  OptionValues& values = request.values;
  for (const char* const group : { "Drawing", "Details", "PDF" })
  {
    addOptions(app,
      { group,
        { "CutOnFold", "Folds", "PatternName", "PatternSize", "PieceNames", "PieceQuantities" } },
      values);
  }
  app
    .add_option_function<std::vector<std::string>>(
      "--fold",
      [&values](const std::vector<std::string>& names) {
        std::vector<std::string> curves = names;
        const auto end = std::remove(curves.begin(), curves.end(), "symmetric");
        values.set("CutOnFold", end == curves.end() ? 0.0 : 1.0);
        curves.erase(end, curves.end());
        values.set("Folds", curves);
      },
      "Draw pieces to cut on the fold of the cloth, along this curve, or every symmetric one. The "
      "curve halves a symmetric piece, which is drawn by half, or borders a piece that is a half; "
      "repeat it for the next")
    ->type_name("NAME|symmetric")
    ->allow_extra_args(false);
  addPieces(app, request);
  app
    .add_option_function<std::string>(
      "--name",
      [&values](const std::string& name) {
        values.set("PatternName", name);
        values.markGiven("PatternName");
      },
      "Name of the pattern (default: that of the surface)")
    ->type_name("NAME");
  app.add_option("--size", request.size, "Size that the pattern is for")->type_name("NAME");
  app
    .add_option_function<std::string>(
      "--style",
      [&values](const std::string& style) {
        values.set("LaserColors", style == "laser" ? 1.0 : 0.0);
        values.set("CutterStyle", style != "sewing" ? 1.0 : 0.0);
      },
      "What the files are for: sewing, laser or cutter. Laser and cutter: a DXF with the layers "
      "CUT, MARK and TEXT, each line once, with arcs; laser: thin lines in SVG as well, a color "
      "for "
      "each role")
    ->transform(CLI::IsMember({ "sewing", "laser", "cutter" }, CLI::ignore_case).description(""))
    ->type_name("STYLE");
}

void addNesting(CLI::App& app, PatternRequest& request)
{
  addOptions(app, { "Cloth", { "FabricWidth" } }, request.values);
  app
    .add_option_function<double>(
      "--roll-width",
      [&values = request.values](double width) { values.set("FabricWidth", width); },
      "Width of the cloth, with the grain along it")
    ->transform(length([&option = *request.values.find("FabricWidth")](
                         double width) { return width > 0.0 && isValid(option, width); },
      '(' + rangeOf(*request.values.find("FabricWidth")).substr(1)))
    ->type_name("MM")
    ->required();
}
}
