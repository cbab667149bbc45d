// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns.h"

#include "Flattening.h"
#include "InputError.h"
#include "OutputFiles.h"
#include "PlainText.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkPatternWriter.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>

namespace wirewarp
{
namespace
{
CLI::Validator length(double least, double most, const std::string& range)
{
  return CLI::Validator(
    [least, most, range](std::string& text) {
      double value = 0.0;
      const bool valid = parseNumber(text, value) && value >= least && value <= most;
      return valid ? std::string() : inQuotes(text) + " is not a number in " + range;
    },
    "in " + range);
}

/// Splits NAME=MM at the last '=', since names may hold one.
bool splitAllowance(const std::string& text, std::string& name, double& allowance)
{
  const std::size_t at = text.rfind('=');
  if (at == std::string::npos || at == 0)
  {
    return false;
  }
  name = text.substr(0, at);
  return parseNumber(text.substr(at + 1), allowance) && allowance >= 0.0 && allowance <= 1e6;
}

int paperValue(const std::string& name)
{
  return name == "letter" ? vtkPatternWriter::LETTER
    : name == "A3"        ? vtkPatternWriter::A3
    : name == "A0"        ? vtkPatternWriter::A0
    : name == "sheet"     ? vtkPatternWriter::SHEET
                          : vtkPatternWriter::A4;
}

void configure(vtkPatternWriter* writer, const PatternRequest& request, const std::string& surface)
{
  if (!request.unit.empty())
  {
    writer->SetUnitByName(request.unit);
  }
  writer->SetPatternName(
    request.name.empty() ? std::filesystem::path(surface).stem().string() : request.name);
  writer->SetPatternSize(request.size);
  writer->SetQuantity(request.quantity);
  for (std::size_t p = 0; p < request.pieceNames.size(); ++p)
  {
    writer->SetPieceName(static_cast<int>(p), request.pieceNames[p]);
  }
  writer->SetAllowance(request.allowance);
  for (const std::string& text : request.curveAllowances)
  {
    std::string name;
    double allowance = 0.0;
    splitAllowance(text, name, allowance);
    writer->SetCurveAllowance(name, allowance);
  }
  writer->SetMitreLimit(request.mitreLimit);
  writer->SetNotchSpacing(request.notchSpacing);
  writer->SetCutDartsOut(request.cutDartsOut);
  writer->SetPaper(paperValue(request.paper));
  writer->SetPageOverlap(request.overlap);
  writer->SetMaximumPages(request.maximumPages);
}
}

//------------------------------------------------------------------------------
void addPatternOptions(CLI::App& app, PatternRequest& request)
{
  const std::string group = "Pattern to cut (lengths in mm)";
  const double large = 1e6;
  app.add_flag("--svg", request.svg, "Write pattern.svg")->group(group);
  app.add_flag("--pdf", request.pdf, "Write pattern.pdf, 1:1 on pages to be joined")->group(group);
  app.add_flag("--dxf", request.dxf, "Write pattern.dxf, R12 after ASTM D6673 / AAMA")
    ->group(group);
  app
    .add_option(
      "--unit", request.unit, "Unit of SURFACE: mm, cm, m, inch (default: cm, with a warning)")
    ->check(CLI::IsMember({ "mm", "cm", "m", "inch" }))
    ->group(group);
  app.add_option("--name", request.name, "Name of the pattern (default: that of the file SURFACE)")
    ->group(group);
  app.add_option("--size", request.size, "Size that the pattern is for")->group(group);
  app.add_option("--quantity", request.quantity, "How many of each piece are cut")
    ->check(CLI::Range(1, 1000000))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--piece-name", request.pieceNames,
      "Name of a piece; the first is for piece 0, repeat it for the next")
    ->allow_extra_args(false)
    ->group(group);
  app.add_option("--allowance", request.allowance, "Seam allowance")
    ->check(length(0.0, large, "[0, 1e6]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--curve-allowance", request.curveAllowances,
      "Seam allowance along one curve, or along 'boundary'; repeat it for the next")
    ->allow_extra_args(false)
    ->check(CLI::Validator(
      [](std::string& text) {
        std::string name;
        double allowance = 0.0;
        return splitAllowance(text, name, allowance)
          ? std::string()
          : inQuotes(text) + " is not the name of a curve, '=', and a number in [0, 1e6]";
      },
      "NAME=MM"))
    ->group(group);
  app.add_option("--mitre-limit", request.mitreLimit, "Longest mitre of a corner, in allowances")
    ->check(length(1.0, 100.0, "[1, 100]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--notch-spacing", request.notchSpacing,
      "Distance of notches along seams and darts, from their start, on the surface; the middle "
      "where "
      "they are shorter. 0: none but at the mouths of darts")
    ->check(length(0.0, large, "[0, 1e6]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_flag("--cut-darts-out", request.cutDartsOut,
      "Cut darts out along their seam allowance instead of folding them")
    ->group(group);
  app.add_option("--paper", request.paper, "Paper of the PDF; sheet: one page for all")
    ->check(CLI::IsMember({ "A4", "letter", "A3", "A0", "sheet" }, CLI::ignore_case))
    ->capture_default_str()
    ->group(group);
  app.add_option("--page-overlap", request.overlap, "How far pages overlap")
    ->check(length(0.0, 50.0, "[0, 50]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--max-pages", request.maximumPages,
      "A PDF of more pages is refused: the unit is likely wrong")
    ->check(CLI::Range(1, 100000))
    ->capture_default_str()
    ->group(group);
}

//------------------------------------------------------------------------------
std::vector<std::string> addPatterns(const PatternRequest& request, const std::string& surface,
  const Flattening& result, OutputFiles& files)
{
  std::vector<std::string> names;
  vtkNew<vtkPatternWriter> writer;
  configure(writer, request, surface);
  writer->SetInputData(0, result.flat);
  writer->SetInputData(1, result.wires);
  writer->SetInputData(2, result.cut);
  const auto add = [&](bool wanted, const std::string& name, int format) {
    if (!wanted)
    {
      return;
    }
    const VtkMessages messages;
    writer->SetFileFormat(format);
    files.add(name, [&writer](const std::string& path) {
      writer->SetFileName(path.c_str());
      return writer->Write() == 1 ? std::string() : std::string(writer->GetErrorMessage());
    });
    names.push_back(name);
  };
  add(request.svg, "pattern.svg", vtkPatternWriter::SVG);
  add(request.pdf, "pattern.pdf", vtkPatternWriter::PDF);
  add(request.dxf, "pattern.dxf", vtkPatternWriter::DXF);
  if (!names.empty() && request.unit.empty())
  {
    std::cerr << "wirewarp: warning: the unit of " << plainText(surface)
              << " is taken as cm; state it with --unit mm, cm, m or inch\n";
  }
  return names;
}
}
