// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns.h"

#include "FlagWords.h"
#include "Flattening.h"
#include "InputError.h"
#include "Options.h"
#include "OutputFiles.h"
#include "PlainText.h"
#include "TableOptions.h"
#include "TextFile.h"
#include "Units.h"
#include "VtkMessages.h"

#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveImprinter.h>
#include <vtkFlatPieceAlgorithm.h>
#include <vtkNew.h>
#include <vtkPatternWriter.h>
#include <vtkStringArray.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <vtkTable.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <system_error>
#include <utility>

namespace wirewarp
{
namespace
{
int paperValue(const std::string& name)
{
  return name == "letter" ? vtkPatternWriter::LETTER
    : name == "A3"        ? vtkPatternWriter::A3
    : name == "A0"        ? vtkPatternWriter::A0
    : name == "sheet"     ? vtkPatternWriter::SHEET
                          : vtkPatternWriter::A4;
}

/// Calls with name and number of each NAME=NUMBER.
template <typename Call>
void forEach(const std::vector<std::string>& entries, const Call& call)
{
  for (const std::string& entry : entries)
  {
    std::string name;
    double number = 0.0;
    splitNameAndNumber(entry, name, number);
    call(name, number);
  }
}

void configure(vtkPatternWriter* writer, const PatternRequest& request, const std::string& surface,
  const std::string& unit)
{
  writer->SetUnitByName(unit);
  writer->SetPatternName(
    request.name.empty() ? std::filesystem::path(surface).stem().string() : request.name);
  writer->SetPatternSize(request.size);
  writer->SetQuantity(request.quantity);
  for (std::size_t p = 0; p < request.pieceQuantities.size(); ++p)
  {
    if (request.pieceQuantities[p] > 0)
    {
      writer->SetPieceQuantity(static_cast<int>(p), request.pieceQuantities[p]);
    }
  }
  for (std::size_t p = 0; p < request.pieceNames.size(); ++p)
  {
    if (!request.pieceNames[p].empty())
    {
      writer->SetPieceName(static_cast<int>(p), request.pieceNames[p]);
    }
  }
  writer->SetAllowance(request.allowance);
  forEach(request.curveAllowances, [writer](const std::string& name, double allowance) {
    writer->SetCurveAllowance(name, allowance);
  });
  forEach(request.curveNotches,
    [writer](const std::string& name, double distance) { writer->AddCurveNotch(name, distance); });
  for (const std::string& name : request.doubleNotches)
  {
    writer->AddDoubleNotches(name);
  }
  writer->SetNotchCorners(request.notchCorners);
  writer->SetNotchCurveEnds(request.notchCurveEnds);
  forEach(request.curveFairs, [writer](const std::string& name, double tolerance) {
    writer->SetCurveFairTolerance(name, tolerance);
  });
  writer->SetMitreLimit(request.mitreLimit);
  writer->SetNotchSpacing(request.notchSpacing);
  writer->SetCutDartsOut(request.cutDartsOut);
  writer->SetCutOnFold(request.cutOnFold);
  for (const std::string& name : request.folds)
  {
    writer->AddFold(name);
  }
  writer->SetDartTip(request.dartTip);
  forEach(request.curveDartTips, [writer](const std::string& name, double distance) {
    writer->SetCurveDartTip(name, distance);
  });
  writer->SetWalkTable(request.seamTable);
  writer->SetCutPairs(request.cutPairs);
  writer->SetFairTolerance(request.fairTolerance);
  writer->SetSymmetrize(request.symmetrize);
  writer->SetLaserColors(request.laserColours);
  writer->SetFabricNap(request.nap);
  writer->SetFabricGap(request.fabricGap);
  writer->SetPaper(paperValue(request.paper));
  writer->SetPageOverlap(request.overlap);
  writer->SetMaximumPages(request.maximumPages);
}

/// Whether the material is known, or said by its file, not to fray.
bool isSheet(const std::string& material)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(material, ignored))
  {
    const auto file = nlohmann::json::parse(readWholeFile(material), nullptr, false, true);
    return file.is_object() && file.contains("sheet") && file["sheet"] == true;
  }
  const vtkNew<vtkTable> known;
  vtkFlatPieceAlgorithm::ListMaterials(known);
  for (vtkIdType row = 0; row < known->GetNumberOfRows(); ++row)
  {
    const std::string name = textIn(known, row, "Name");
    const bool same = std::equal(name.begin(), name.end(), material.begin(), material.end(),
      [](char one, char given) { return one == std::tolower(static_cast<unsigned char>(given)); });
    if (same)
    {
      return integerIn(known, row, "Sheet") != 0;
    }
  }
  return false;
}

/// About a sixth of the largest piece, as 1, 2 or 5 times a power of ten, in mm.
double notchSpacingOf(const Flattening& result)
{
  double largest = 0.0;
  vtkTable* const pieces = result.tables.pieces;
  for (vtkIdType piece = 0; piece < pieces->GetNumberOfRows(); ++piece)
  {
    largest = std::max(
      { largest, numberIn(pieces, piece, "FlatWidth"), numberIn(pieces, piece, "FlatHeight") });
  }
  const double wanted = largest * millimetresOf(result.unit) / 6.0;
  if (!(wanted > 0.0) || !std::isfinite(wanted))
  {
    return 100.0;
  }
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double first = wanted / power;
  return power *
    (first < std::sqrt(2.0)       ? 1.0
        : first < std::sqrt(10.0) ? 2.0
        : first < std::sqrt(50.0) ? 5.0
                                  : 10.0);
}

/// The request with what it leaves to material and pieces.
PatternRequest completed(const Options& options, const Flattening& result)
{
  PatternRequest request = options.pattern;
  if (request.allowance < 0.0)
  {
    request.allowance = isSheet(options.values.text("Material")) ? 0.0 : 10.0;
  }
  if (request.notchSpacing < 0.0)
  {
    request.notchSpacing = notchSpacingOf(result);
  }
  return request;
}

bool isNews(int kind, const PatternRequest& request, bool quiet)
{
  const bool asked = request.fairGiven || !request.curveFairs.empty();
  switch (kind)
  {
    case vtkPatternWriter::SMOOTHED:
      return asked && !quiet;
    case vtkPatternWriter::LEFT_ROUGH:
      return asked;
    case vtkPatternWriter::NOT_SMOOTHED:
      return asked || !quiet;
    case vtkPatternWriter::NOT_MIRRORED:
      return true;
    default:
      return !quiet;
  }
}

/// What the writer refused to write to a path, in the command's words.
std::string refusalOf(vtkPatternWriter* writer, const std::string& path)
{
  if (std::string(writer->GetStatusName()) == "OutOfMemory")
  {
    throw std::bad_alloc();
  }
  // The file of that name is one beside the user's, whom nobody has told of it.
  std::string defect = writer->GetStatusDefect();
  const std::size_t at = defect.find(path + ' ');
  return messageOf(at == 0 ? defect.substr(path.size() + 1) : defect, remediesOf(writer));
}

/// \return what is wrong, or nothing
std::string write(vtkPatternWriter* writer, const PatternFile& file, OutputFiles& files)
{
  writer->SetFileFormat(file.format);
  return files.add(file.path, [writer](const std::string& path) {
    writer->SetFileName(path.c_str());
    return writer->Write() == 1 ? std::string() : refusalOf(writer, path);
  });
}
}

void checkCurveNames(const PatternRequest& request, const std::string& surface,
  vtkFeatureCurveAlgorithm* filter, Flattening& result)
{
  const VtkMessages messages;
  vtkNew<vtkPatternWriter> writer;
  configure(writer, request, surface, result.unit);
  if (!request.any() ||
    (request.folds.empty() && writer->GetCurvesWithOptions()->GetNumberOfValues() == 0))
  {
    return;
  }
  vtkNew<vtkFeatureCurveImprinter> imprinter;
  imprinter->SetInputConnection(filter->GetInputConnection(0, 0));
  for (int k = 0; k < filter->GetNumberOfInputConnections(1); ++k)
  {
    imprinter->AddCurvesConnection(filter->GetInputConnection(1, k));
  }
  imprinter->SetSplitTriangles(filter->GetSplitTriangles());
  imprinter->SetImprintTolerance(filter->GetImprintTolerance());
  imprinter->SetSnapTolerance(filter->GetSnapTolerance());
  imprinter->Update();
  if (!imprinter->IsRefused() &&
    !writer->CheckCurveNames(
      imprinter->GetOutput(1), filter->IsA("vtkFeatureCurveSuggestion") != 0))
  {
    result.exitCode = InputRefused;
    result.status = writer->GetStatusName();
    result.message = refusalOf(writer, "");
  }
}

std::vector<std::string> addPatterns(const Options& options, Flattening& result, OutputFiles& files)
{
  const PatternRequest request = completed(options, result);
  std::vector<std::string> names;
  std::set<std::string> warnings;              // of all formats alike
  std::map<std::string, int> notes;            // with their kinds
  std::map<std::string, std::string> failures; // files by what is wrong with them
  vtkNew<vtkPatternWriter> writer;
  configure(writer, request, options.surface, result.unit);
  writer->SetInputData(0, result.flat);
  writer->SetInputData(1, result.wires);
  writer->SetInputData(2, result.cut);
  if (result.grading)
  {
    writer->SetInputData(3, result.grading);
  }
  for (const PatternFile& file : request.files)
  {
    const VtkMessages messages;
    writer->SetFabricWidth(file.onCloth ? request.fabricWidth : 0.0);
    const std::string problem = write(writer, file, files);
    if (!problem.empty())
    {
      std::string& failed = failures[problem];
      failed += (failed.empty() ? "" : ", ") + file.path;
      continue;
    }
    for (int k = 0; k < writer->GetNumberOfWarnings(); ++k)
    {
      warnings.insert(writer->GetWarning(k));
    }
    for (int k = 0; k < writer->GetNumberOfNotes(); ++k)
    {
      notes.emplace(writer->GetNote(k), writer->GetNoteKind(k));
    }
    names.push_back(file.path);
    if (file.onCloth)
    {
      result.layWidth = request.fabricWidth;
      result.layLength = writer->GetFabricLength();
      result.layEfficiency = writer->GetFabricEfficiency();
    }
  }
  for (const auto& [problem, failed] : failures)
  {
    result.unwritten.push_back(failed);
    result.unwritten.back().append(": ").append(problem);
  }
  for (const std::string& warning : warnings)
  {
    std::cerr << "wirewarp: warning: " << plainText(warning)
              << "; draw it as 'straight NAME v0 v1', or with KeyShape 1\n";
  }
  for (const auto& [note, kind] : notes)
  {
    result.patternNotes.push_back(note);
    if (!isNews(kind, request, options.quiet))
    {
      continue;
    }
    std::cerr << "wirewarp: note: " << plainText(note) << "\n";
  }
  return names;
}

namespace
{
constexpr double largestLength = 1e6;

/// Lengths of all curves, or NAME=MM of one.
void addLengths(CLI::App& app, const std::string& name, double& length,
  std::vector<std::string>& ofCurves, const std::string& text, const std::string& byDefault)
{
  app
    .add_option_function<std::vector<std::string>>(
      name,
      [name, &length, &ofCurves](const std::vector<std::string>& entries) {
        ofCurves.clear();
        for (const std::string& entry : entries)
        {
          std::string curve;
          double given = 0.0;
          const bool named = splitNameAndNumber(entry, curve, given);
          if ((!named && !parseNumber(entry, given)) || !(given >= 0.0 && given <= largestLength))
          {
            throw CLI::ValidationError(name,
              inQuotes(entry) + " is neither a length in mm from 0 to 1e6 nor NAME=MM of a curve");
          }
          length = named ? length : given;
          if (named)
          {
            ofCurves.push_back(entry);
          }
        }
      },
      text)
    ->type_name("MM|NAME=MM")
    ->default_str(byDefault)
    ->allow_extra_args(false);
}

/// NAME, NAME:QUANTITY or :QUANTITY of the pieces in their order.
void addPieces(CLI::App& app, PatternRequest& request)
{
  app
    .add_option_function<std::vector<std::string>>(
      "--piece",
      [&request](const std::vector<std::string>& entries) {
        request.pieceNames.clear();
        request.pieceQuantities.clear();
        for (const std::string& entry : entries)
        {
          const std::size_t colon = entry.rfind(':');
          long long quantity = 0;
          const bool counted =
            colon != std::string::npos && parseInteger(entry.substr(colon + 1), quantity);
          if (counted && (quantity < 1 || quantity > 1000000))
          {
            throw CLI::ValidationError(
              "--piece", inQuotes(entry) + " is not NAME:QUANTITY with 1 to 1000000 copies");
          }
          request.pieceNames.push_back(counted ? entry.substr(0, colon) : entry);
          request.pieceQuantities.push_back(static_cast<int>(quantity));
        }
      },
      "Name of a piece and how many are cut, from piece 1 on; repeat it for the next")
    ->type_name("NAME[:COPIES]")
    ->allow_extra_args(false);
}
}

void addDrawing(CLI::App& app, PatternRequest& request)
{
  addLengths(app, "--allowance", request.allowance, request.curveAllowances,
    "Seam allowance; NAME=MM: along one curve, or along 'boundary'; repeat it for the next",
    "10, sheets 0");
  app
    .add_option("--notch-spacing", request.notchSpacing,
      "Distance of notches along seams and darts (default: about a sixth of the largest piece). "
      "From their start, on the surface; the middle where they are shorter. 0: none but at the "
      "mouths of darts")
    ->check(number(0.0, largestLength, "[0, 1e6]"))
    ->type_name("MM");
  app
    .add_option("--notch", request.curveNotches,
      "A notch at this distance from the start of a curve. It replaces those by --notch-spacing "
      "on a seam, a dart or an edge; repeat it for the next")
    ->allow_extra_args(false)
    ->check(nameAndMillimetres())
    ->type_name("NAME=MM");
  app
    .add_option("--double-notch", request.doubleNotches,
      "A curve whose notches are double, as at the back. Two marks 6.35 mm apart; repeat it for "
      "the next")
    ->type_name("NAME")
    ->allow_extra_args(false);
  app.add_flag("--notch-corners", request.notchCorners,
    "Notch the cut line at corners, where the sew lines, drawn on, meet it");
  app.add_flag("--notch-curve-ends", request.notchCurveEnds,
    "Notch the border where feature curves and edges end on it, and opposite on what is sewn to "
    "it");
  addLengths(app, "--smooth", request.fairTolerance, request.curveFairs,
    "Draw borders as smooth splines at most this far from the mesh. They keep their lengths and "
    "are straight where nearly so; 0: raw, as the mesh has them; NAME=MM: along one curve, or "
    "along 'boundary'",
    "0.2");
  app.get_option("--smooth")->each([&request](const std::string&) { request.fairGiven = true; });
  app
    .add_option_function<std::vector<std::string>>(
      "--fold",
      [&request](const std::vector<std::string>& names) {
        request.folds.clear();
        for (const std::string& name : names)
        {
          if (name == "symmetric")
          {
            request.cutOnFold = true;
            continue;
          }
          request.folds.push_back(name);
        }
      },
      "Cut on the fold of the cloth along this curve, or every symmetric piece. A half of a piece "
      "that is symmetric about the curve, or a piece that is a half and has it on its border; "
      "repeat it for the next")
    ->type_name("NAME|symmetric")
    ->allow_extra_args(false);
  app.add_flag("--pairs", request.cutPairs,
    "Of two pieces that are mirror images draw the first. It is cut in pairs of which one is "
    "turned over");
  addLengths(app, "--dart-tip", request.dartTip, request.curveDartTips,
    "How far tips of folded darts are drawn back. Their legs with them, which are shorter then; "
    "NAME=MM: of one dart",
    "0");
  app.add_flag("--cut-darts-out", request.cutDartsOut,
    "Cut darts out along their seam allowance instead of folding them");
  addPieces(app, request);
  app.add_option("--quantity", request.quantity, "How many of each piece are cut")
    ->check(CLI::Range(1, 1000000).description(""))
    ->type_name("N")
    ->capture_default_str();
  app.add_option("--name", request.name, "Name of the pattern (default: that of the surface)")
    ->type_name("NAME");
  app.add_option("--size", request.size, "Size that the pattern is for")->type_name("NAME");
  app
    .add_option("--paper", request.paper, "Paper of the PDF: A4, letter, A3, A0, sheet (one page)")
    ->transform(
      CLI::IsMember({ "A4", "letter", "A3", "A0", "sheet" }, CLI::ignore_case).description(""))
    ->type_name("PAPER")
    ->capture_default_str();
  app
    .add_option_function<std::string>(
      "--style", [&request](const std::string& style) { request.laserColours = style == "laser"; },
      "Lines of the SVG: sewing, or laser (thin lines, a color for each role)")
    ->transform(CLI::IsMember({ "sewing", "laser" }, CLI::ignore_case).description(""))
    ->type_name("STYLE");
  app.add_flag(
    "--seam-table", request.seamTable, "Append the lengths of both sides of seams to the PDF");
  app.add_option("--mitre-limit", request.mitreLimit, "Longest miter of a corner, in allowances")
    ->check(number(1.0, 100.0, "[1, 100]"))
    ->capture_default_str();
  app.add_flag("--symmetrize", request.symmetrize,
    "Draw the outline of each piece that is symmetric to 0.5 mm as exactly its own mirror image; "
    "sides whose lengths differ by up to 0.1 mm get "
    "their mean");
  app.add_option("--page-overlap", request.overlap, "How far pages overlap, in mm")
    ->check(number(0.0, 50.0, "[0, 50]"))
    ->capture_default_str();
  app
    .add_option("--max-pages", request.maximumPages,
      "Most pages of a PDF; with more the unit is likely wrong")
    ->check(CLI::Range(1, 100000))
    ->capture_default_str();
}

void addNesting(CLI::App& app, PatternRequest& request)
{
  app
    .add_option("--roll-width", request.fabricWidth, "Width of the cloth, with the grain along it")
    ->check(number(std::numeric_limits<double>::min(), 1e5, "(0, 1e5]"))
    ->type_name("MM")
    ->required();
  app.add_flag("--nap", request.nap, "The cloth has an up and a down: no piece is turned round");
  app.add_option("--gap", request.fabricGap, "Least distance of pieces on the cloth")
    ->check(number(0.0, 1000.0, "[0, 1000]"))
    ->type_name("MM")
    ->capture_default_str();
}
}
