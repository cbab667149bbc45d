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
#include "VtkMessages.h"

#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveImprinter.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <utility>

namespace wirewarp
{
namespace
{
void configure(const PatternRequest& request, const std::string& surface, const std::string& unit)
{
  request.writer->SetUnitByName(unit);
  request.writer->SetPatternName(
    request.name.empty() ? std::filesystem::path(surface).stem().string() : request.name);
  request.writer->SetPatternSize(request.size);
}

bool isNews(int kind, const PatternRequest& request, bool quiet)
{
  const bool asked = request.smoothAsked;
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
  vtkPatternWriter* const writer = request.writer;
  configure(request, surface, result.unit);
  if (!request.any() || writer->GetCurvesWithOptions()->GetNumberOfValues() == 0)
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
  const PatternRequest& request = options.pattern;
  std::vector<std::string> names;
  std::set<std::string> warnings;              // of all formats alike
  std::map<std::string, int> notes;            // with their kinds
  std::map<std::string, std::string> failures; // files by what is wrong with them
  vtkPatternWriter* const writer = request.writer;
  configure(request, options.surface, result.unit);
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

using SetLength = std::function<void(double)>;
using SetLengthOfCurve = std::function<void(const std::string&, double)>;

std::string shown(double value)
{
  return CLI::detail::to_string(value);
}

/// Lengths of all curves, or NAME=MM of one.
void addLengths(CLI::App& app, const std::string& name, const SetLength& set,
  const SetLengthOfCurve& setOfCurve, const std::string& text, const std::string& byDefault)
{
  app
    .add_option_function<std::vector<std::string>>(
      name,
      [name, set, setOfCurve](const std::vector<std::string>& entries) {
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
          named ? setOfCurve(curve, given) : set(given);
        }
      },
      text)
    ->type_name("MM|NAME=MM")
    ->default_str(byDefault)
    ->allow_extra_args(false);
}

/// Names of curves, one at a time.
void addNames(CLI::App& app, const std::string& name,
  const std::function<void(const std::string&)>& add, const std::string& form,
  const std::string& text)
{
  app
    .add_option_function<std::vector<std::string>>(
      name,
      [add](const std::vector<std::string>& entries) {
        std::for_each(entries.begin(), entries.end(), add);
      },
      text)
    ->type_name(form)
    ->allow_extra_args(false);
}

/// NAME, NAME:QUANTITY or :QUANTITY of the pieces in their order.
void addPieces(CLI::App& app, vtkPatternWriter* writer)
{
  app
    .add_option_function<std::vector<std::string>>(
      "--piece",
      [writer](const std::vector<std::string>& entries) {
        int piece = 0;
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
          const std::string name = counted ? entry.substr(0, colon) : entry;
          if (!name.empty())
          {
            writer->SetPieceName(piece, name);
          }
          if (counted)
          {
            writer->SetPieceQuantity(piece, static_cast<int>(quantity));
          }
          ++piece;
        }
      },
      "Name of a piece and how many are cut, from piece 1 on; repeat it for the next")
    ->type_name("NAME[:COPIES]")
    ->allow_extra_args(false);
}
}

void addDrawing(CLI::App& app, PatternRequest& request)
{
  vtkPatternWriter* const writer = request.writer;
  const auto set = [writer](void (vtkPatternWriter::*method)(double)) -> SetLength {
    return [writer, method](double value) { (writer->*method)(value); };
  };
  const auto setOfCurve = [writer](void (vtkPatternWriter::*method)(const std::string&, double)) {
    return
      [writer, method](const std::string& curve, double value) { (writer->*method)(curve, value); };
  };
  const auto addFlag = [&app, writer](const std::string& name,
                         void (vtkPatternWriter::*method)(bool), const std::string& text) {
    app.add_flag_callback(
      name, [writer, method] { (writer->*method)(true); }, text);
  };
  addLengths(app, "--allowance", set(&vtkPatternWriter::SetAllowance),
    setOfCurve(&vtkPatternWriter::SetCurveAllowance),
    "Seam allowance; NAME=MM: along one curve, or along 'boundary'; repeat it for the next",
    "10, sheets 0");
  app
    .add_option_function<double>("--notch-spacing", set(&vtkPatternWriter::SetNotchSpacing),
      "Distance of notches along seams and darts (default: about a sixth of the largest piece). "
      "From their start, on the surface; the middle where they are shorter. 0: none but at the "
      "mouths of darts")
    ->check(number(0.0, largestLength, "[0, 1e6]"))
    ->type_name("MM");
  app
    .add_option_function<std::vector<std::string>>(
      "--notch",
      [writer](const std::vector<std::string>& entries) {
        for (const std::string& entry : entries)
        {
          std::string name;
          double distance = 0.0;
          splitNameAndNumber(entry, name, distance);
          writer->AddCurveNotch(name, distance);
        }
      },
      "A notch at this distance from the start of a curve. It replaces those by --notch-spacing "
      "on a seam, a dart or an edge; repeat it for the next")
    ->allow_extra_args(false)
    ->check(nameAndMillimetres())
    ->type_name("NAME=MM");
  addNames(
    app, "--double-notch", [writer](const std::string& name) { writer->AddDoubleNotches(name); },
    "NAME",
    "A curve whose notches are double, as at the back. Two marks 6.35 mm apart; repeat it for "
    "the next");
  addFlag("--notch-corners", &vtkPatternWriter::SetNotchCorners,
    "Notch the cut line at corners, where the sew lines, drawn on, meet it");
  addFlag("--notch-curve-ends", &vtkPatternWriter::SetNotchCurveEnds,
    "Notch the border where feature curves and edges end on it, and opposite on what is sewn to "
    "it");
  const std::vector<std::string> axes{ "auto", "x", "y", "z", "none" };
  app
    .add_option_function<std::string>(
      "--up",
      [axes, writer](const std::string& axis) {
        const auto found = std::find(axes.begin(), axes.end(), axis);
        writer->SetUpAxis(static_cast<int>(found - axes.begin()));
      },
      "The axis of SURFACE that points up in each piece, with the grain along it. Not of pieces "
      "with a grain of their own; auto: of y and z that along which it is larger; none: no piece "
      "is turned")
    ->transform(CLI::IsMember(axes, CLI::ignore_case).description(""))
    ->type_name("auto|x|y|z|none")
    ->default_str(axes[static_cast<std::size_t>(writer->GetUpAxis())]);
  app.add_flag_callback(
    "--no-join-marks", [writer] { writer->SetJoinMarks(false); },
    "No letters along the two sides of what is sewn together");
  addLengths(app, "--smooth", set(&vtkPatternWriter::SetFairTolerance),
    setOfCurve(&vtkPatternWriter::SetCurveFairTolerance),
    "Draw borders as smooth splines at most this far from the mesh. They keep their lengths and "
    "are straight where nearly so; 0: raw, as the mesh has them; NAME=MM: along one curve, or "
    "along 'boundary'",
    shown(writer->GetFairTolerance()));
  app.get_option("--smooth")->each([&request](const std::string&) { request.smoothAsked = true; });
  addNames(
    app, "--fold",
    [writer](const std::string& name) {
      name == "symmetric" ? writer->SetCutOnFold(true) : writer->AddFold(name);
    },
    "NAME|symmetric",
    "Cut on the fold of the cloth along this curve, or every symmetric piece. A half of a piece "
    "that is symmetric about the curve, or a piece that is a half and has it on its border; "
    "repeat it for the next");
  addFlag("--pairs", &vtkPatternWriter::SetCutPairs,
    "Of two pieces that are mirror images draw the first. It is cut in pairs of which one is "
    "turned over");
  addLengths(app, "--dart-tip", set(&vtkPatternWriter::SetDartTip),
    setOfCurve(&vtkPatternWriter::SetCurveDartTip),
    "How far tips of folded darts are drawn back. Their legs with them, which are shorter then; "
    "NAME=MM: of one dart",
    shown(writer->GetDartTip()));
  addFlag("--cut-darts-out", &vtkPatternWriter::SetCutDartsOut,
    "Cut darts out along their seam allowance instead of folding them");
  addPieces(app, writer);
  app
    .add_option_function<int>(
      "--quantity", [writer](int quantity) { writer->SetQuantity(quantity); },
      "How many of each piece are cut")
    ->check(CLI::Range(1, 1000000).description(""))
    ->type_name("N")
    ->default_str(shown(writer->GetQuantity()));
  app.add_option("--name", request.name, "Name of the pattern (default: that of the surface)")
    ->type_name("NAME");
  app.add_option("--size", request.size, "Size that the pattern is for")->type_name("NAME");
  const std::vector<std::string> papers{ "A4", "letter", "A3", "A0", "sheet" };
  app
    .add_option_function<std::string>(
      "--paper",
      [papers, writer](const std::string& paper) {
        const auto found = std::find(papers.begin(), papers.end(), paper);
        writer->SetPaper(static_cast<int>(found - papers.begin()));
      },
      "Paper of the PDF: A4, letter, A3, A0, sheet (one page)")
    ->transform(CLI::IsMember(papers, CLI::ignore_case).description(""))
    ->type_name("PAPER")
    ->default_str(papers[static_cast<std::size_t>(writer->GetPaper())]);
  app
    .add_option_function<std::string>(
      "--style",
      [writer](const std::string& style) {
        writer->SetLaserColors(style == "laser");
        writer->SetCutterStyle(style != "sewing");
      },
      "What the files are for: sewing, laser or cutter. Laser and cutter: a DXF with the layers "
      "CUT, "
      "MARK and TEXT, each line once, with arcs; laser: thin lines in SVG as well, a color for "
      "each "
      "role")
    ->transform(CLI::IsMember({ "sewing", "laser", "cutter" }, CLI::ignore_case).description(""))
    ->type_name("STYLE");
  addFlag("--seam-table", &vtkPatternWriter::SetWalkTable,
    "Append the lengths of both sides of seams to the PDF");
  app
    .add_option_function<double>("--mitre-limit", set(&vtkPatternWriter::SetMitreLimit),
      "Longest miter of a corner, in allowances")
    ->check(number(1.0, 100.0, "[1, 100]"))
    ->default_str(shown(writer->GetMitreLimit()));
  addFlag("--symmetrize", &vtkPatternWriter::SetSymmetrize,
    "Draw the outline of each piece that is symmetric to 0.5 mm as exactly its own mirror image; "
    "sides whose lengths differ by up to 0.1 mm get "
    "their mean");
  app
    .add_option_function<double>(
      "--page-overlap", set(&vtkPatternWriter::SetPageOverlap), "How far pages overlap, in mm")
    ->check(number(0.0, 50.0, "[0, 50]"))
    ->default_str(shown(writer->GetPageOverlap()));
  app
    .add_option_function<int>(
      "--max-pages", [writer](int pages) { writer->SetMaximumPages(pages); },
      "Most pages of a PDF; with more the unit is likely wrong")
    ->check(CLI::Range(1, 100000))
    ->default_str(shown(writer->GetMaximumPages()));
}

void addNesting(CLI::App& app, PatternRequest& request)
{
  vtkPatternWriter* const writer = request.writer;
  app
    .add_option("--roll-width", request.fabricWidth, "Width of the cloth, with the grain along it")
    ->check(number(std::numeric_limits<double>::min(), 1e5, "(0, 1e5]"))
    ->type_name("MM")
    ->required();
  app.add_flag_callback(
    "--nap", [writer] { writer->SetFabricNap(true); },
    "The cloth has an up and a down: no piece is turned round");
  app
    .add_option_function<double>(
      "--gap", [writer](double gap) { writer->SetFabricGap(gap); },
      "Least distance of pieces on the cloth")
    ->check(number(0.0, 1000.0, "[0, 1000]"))
    ->type_name("MM")
    ->default_str(shown(writer->GetFabricGap()));
}
}
