// SPDX-License-Identifier: BSD-3-Clause
#include "Patterns.h"

#include "FlagWords.h"
#include "Flattening.h"
#include "InputError.h"
#include "NumberOptions.h"
#include "OutputFiles.h"
#include "PlainText.h"
#include "VtkMessages.h"

#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveImprinter.h>
#include <vtkPatternWriter.h>
#include <vtkStringArray.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <new>
#include <set>
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
  for (const std::string& text : request.curveAllowances)
  {
    std::string name;
    double allowance = 0.0;
    splitNameAndNumber(text, name, allowance);
    writer->SetCurveAllowance(name, allowance);
  }
  for (const std::string& text : request.curveNotches)
  {
    std::string name;
    double distance = 0.0;
    splitNameAndNumber(text, name, distance);
    writer->AddCurveNotch(name, distance);
  }
  for (const std::string& name : request.doubleNotches)
  {
    writer->AddDoubleNotches(name);
  }
  writer->SetNotchCorners(request.notchCorners);
  writer->SetNotchCurveEnds(request.notchCurveEnds);
  for (const std::string& text : request.curveFairs)
  {
    std::string name;
    double tolerance = 0.0;
    splitNameAndNumber(text, name, tolerance);
    writer->SetCurveFairTolerance(name, tolerance);
  }
  writer->SetMitreLimit(request.mitreLimit);
  writer->SetNotchSpacing(request.notchSpacing);
  writer->SetCutDartsOut(request.cutDartsOut);
  writer->SetCutOnFold(request.cutOnFold);
  for (const std::string& name : request.folds)
  {
    writer->AddFold(name);
  }
  writer->SetDartTip(request.dartTip);
  for (const std::string& text : request.curveDartTips)
  {
    std::string name;
    double distance = 0.0;
    splitNameAndNumber(text, name, distance);
    writer->SetCurveDartTip(name, distance);
  }
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
std::vector<std::string> addPatterns(const PatternRequest& request, const std::string& surface,
  bool quiet, Flattening& result, OutputFiles& files)
{
  std::vector<std::string> names;
  std::set<std::string> warnings;              // of all formats alike
  std::map<std::string, int> notes;            // with their kinds
  std::map<std::string, std::string> failures; // files by what is wrong with them
  vtkNew<vtkPatternWriter> writer;
  configure(writer, request, surface, result.unit);
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
    if (!isNews(kind, request, quiet))
    {
      continue;
    }
    std::cerr << "wirewarp: note: " << plainText(note) << "\n";
  }
  if (!names.empty() && !result.unitStated && result.sizeWarning.empty()) // which tells of it
  {
    std::cerr << "wirewarp: warning: the unit of " << plainText(surface)
              << " is taken as cm; state it with --unit mm, cm, m or inch\n";
  }
  return names;
}
}
