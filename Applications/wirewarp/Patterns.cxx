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
#include <vtkPatternWriter.h>
#include <vtkSmartPointer.h>
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
using flattening::OptionValues;

/// Hands entries NAME=MM on.
void setOfCurves(const OptionValues& values, const char* property,
  const std::function<void(const std::string&, double)>& set)
{
  for (const std::string& entry : values.list(property))
  {
    const auto [curve, length] = namedNumber(entry, *values.find(property));
    set(curve, length);
  }
}

vtkSmartPointer<vtkPatternWriter> makeWriter(
  const PatternRequest& request, const std::string& surface, const std::string& unit)
{
  const auto writer = vtkSmartPointer<vtkPatternWriter>::New();
  const OptionValues& values = request.values;
  writer->SetOptions(values);
  writer->SetUnitByName(unit);
  if (!values.isGiven("PatternName"))
  {
    writer->SetPatternName(std::filesystem::path(surface).stem().string());
  }
  writer->SetPatternSize(request.size);
  const auto ofCurve = [&writer](void (vtkPatternWriter::*set)(const std::string&, double)) {
    return
      [&writer, set](const std::string& curve, double length) { (writer->*set)(curve, length); };
  };
  setOfCurves(values, "CurveAllowances", ofCurve(&vtkPatternWriter::SetCurveAllowance));
  setOfCurves(values, "CurveDartTips", ofCurve(&vtkPatternWriter::SetCurveDartTip));
  setOfCurves(values, "CurveFairTolerances", ofCurve(&vtkPatternWriter::SetCurveFairTolerance));
  setOfCurves(values, "CurveNotches", ofCurve(&vtkPatternWriter::AddCurveNotch));
  for (const std::string& curve : values.list("DoubleNotches"))
  {
    writer->AddDoubleNotches(curve);
  }
  for (const std::string& curve : values.list("Folds"))
  {
    writer->AddFold(curve);
  }
  for (std::size_t p = 0; p < request.pieces.size(); ++p)
  {
    const auto& [name, copies] = request.pieces[p];
    if (!name.empty())
    {
      writer->SetPieceName(static_cast<int>(p), name);
    }
    writer->SetPieceQuantity(static_cast<int>(p), copies);
  }
  return writer;
}

bool isNews(int kind, const PatternRequest& request, bool quiet)
{
  const bool asked =
    request.values.isGiven("FairTolerance") || request.values.isGiven("CurveFairTolerances");
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
std::string writePattern(vtkPatternWriter* writer, const PatternFile& file, OutputFiles& files)
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
  const auto writer = makeWriter(request, surface, result.unit);
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
  const auto writer = makeWriter(request, options.surface, result.unit);
  const double fabricWidth = writer->GetFabricWidth();
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
    writer->SetFabricWidth(file.onCloth ? fabricWidth : 0.0);
    const std::string problem = writePattern(writer, file, files);
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
      result.layWidth = fabricWidth;
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
    if (!isNews(kind, request, options.quiet || options.command == "make"))
    {
      continue;
    }
    std::cerr << "wirewarp: note: " << plainText(note) << "\n";
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
          if (counted && (quantity < 1 || quantity > 1000000))
          {
            throw CLI::ValidationError(
              "--piece", inQuotes(entry) + " is not NAME:QUANTITY with 1 to 1000000 copies");
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
      "Cut on the fold of the cloth along this curve, or every symmetric piece. A half of a piece "
      "that is symmetric about the curve, or a piece that is a half and has it on its border; "
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
    ->check(number(std::numeric_limits<double>::min(), 1e5, "(0, 1e5]"))
    ->type_name("MM")
    ->required();
}
}
