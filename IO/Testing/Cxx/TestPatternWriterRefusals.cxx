// SPDX-License-Identifier: BSD-3-Clause
// What cannot become a pattern is refused by a status of its own, with the writer's properties for
// a way out, and leaves the earlier file as it was.
#include "FlatteningTesting.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFlatteningAlgorithm.h"
#include "vtkIdTypeArray.h"
#include "vtkPatternWriter.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <fstream>
#include <sstream>

using namespace flatteningTesting;

namespace
{
const char* const earlier = "an earlier pattern";

std::string contentOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

struct Refusals
{
  Checks& Found;
  std::string Folder;

  /// Writes the surface to a file, after what prepare() does to the writer.
  template <class Prepare>
  void refuse(const char* status, vtkPolyData* surface, const Prepare& prepare,
    const std::vector<std::string>& words, unsigned long code = vtkErrorCode::UserError) const
  {
    const std::string path = this->Folder + "/refused.pdf";
    std::ofstream(path) << earlier;
    vtkNew<vtkPatternWriter> writer;
    const Messages messages(writer);
    this->Found.equal(std::string(writer->GetStatusName()), std::string("NotRun"), "at first");
    writer->SetInputData(0, surface);
    writer->SetUnitToCentimetre();
    writer->SetFileName(path.c_str());
    prepare(*writer);
    this->Found.equal(writer->Write(), 0, std::string("what Write() returns of ") + status);
    this->Found.equal(std::string(writer->GetStatusName()), std::string(status), "the status");
    this->Found.equal(writer->GetErrorCode(), code, std::string("VTK's code of ") + status);
    this->Found.equal(messages.errors.size(), std::size_t{ 1 }, std::string("errors of ") + status);
    const std::string message = writer->GetErrorMessage();
    for (const std::string& word : words)
    {
      this->Found.contains(message, word, status);
      this->Found.contains(messages.errors.empty() ? "" : messages.errors.front(), word, status);
    }
    // The message is the defect and the ways out, those that all filters know.
    this->Found.equal(message.rfind(writer->GetStatusDefect(), 0), std::size_t{ 0 }, "the defect");
    for (vtkIdType k = 0; k < writer->GetStatusRemedies()->GetNumberOfValues(); ++k)
    {
      const std::string name = writer->GetStatusRemedies()->GetValue(k);
      const char* const said = vtkFlatteningAlgorithm::GetRemedySentence(name.c_str());
      this->Found.that(said != nullptr, name + " is a remedy");
    }
    this->Found.equal(writer->GetStatusRemedySubjects()->GetNumberOfValues(),
      writer->GetStatusRemedies()->GetNumberOfValues(), "subjects");
    this->Found.equal(contentOf(path), std::string(earlier), "the earlier file");
  }
};

void statusOfSuccess(Checks& checks, const std::string& folder)
{
  vtkNew<vtkPatternWriter> writer;
  const Messages messages(writer);
  writer->SetInputData(0, makeGrid(2, 2));
  writer->SetUnitToCentimetre();
  writer->SetFileName((folder + "/none/pattern.svg").c_str());
  writer->Write();
  checks.equal(std::string(writer->GetStatusName()), std::string("FileNotWritten"), "no folder");
  writer->SetFileName((folder + "/pattern.svg").c_str());
  checks.equal(writer->Write(), 1, "a file that can be written");
  checks.equal(std::string(writer->GetStatusName()), std::string("Ok"), "the status of success");
  checks.equal(std::string(writer->GetErrorMessage()), std::string(), "the message of success");
  checks.equal(writer->GetStatusRemedies()->GetNumberOfValues(), vtkIdType{ 0 }, "ways out");
}
}

int TestPatternWriterRefusals(int argc, char* argv[])
{
  Checks checks;
  const std::string folder = temporaryDirectory(argc, argv);
  const Refusals refusals{ checks, folder };
  const auto plainly = [](vtkPatternWriter&) {};
  const auto grid = makeGrid(3, 3);

  refusals.refuse(
    "NothingToDraw", makePolyData({}, {}), plainly, { "no triangles", "status of the flattening" });
  const auto dome = makePolyData(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0.2 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  refusals.refuse("InvalidPattern", dome, plainly, { "the surface is not flat", "high in z" });
  const auto turned = makePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 2, 1 } });
  refusals.refuse("NothingToDraw", turned, plainly, { "piece 1 of 1", "turned over" });
  vtkNew<vtkIdTypeArray> pieces;
  pieces->SetName("PieceId");
  pieces->InsertNextValue(0);
  const auto shortOfPieces = makeGrid(3, 3);
  shortOfPieces->GetCellData()->AddArray(pieces);
  refusals.refuse(
    "InvalidPattern", shortOfPieces, plainly, { "PieceId", "outputs of one flattening filter" });
  refusals.refuse("InvalidPattern",
    makePolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } },
      { { 0, 1, 2 }, { 0, 3, 4 } }),
    plainly, { "branches at point 0" });
  // A closed octahedron with a triangle across it has one border edge.
  refusals.refuse("InvalidPattern",
    makePolyData({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 }, { 1, -1, 0 }, { 1, 2, 0 }, { 1, -2, 0 } },
      { { 4, 0, 1 }, { 4, 1, 2 }, { 4, 2, 3 }, { 4, 3, 0 }, { 5, 1, 0 }, { 5, 2, 1 }, { 5, 3, 2 },
        { 5, 0, 3 }, { 0, 2, 4 } }),
    plainly, { "ends at point 2" });

  const auto metres = [](vtkPatternWriter& writer) {
    writer.SetUnitToMetre();
    writer.SetMaximumPages(3);
  };
  refusals.refuse(
    "PatternTooLarge", grid, metres, { "1.02 m x 1.02 m", "check the unit", "Paper" });
  refusals.refuse("InvalidOption", grid,
    [](vtkPatternWriter& writer) { writer.SetCurveAllowance("hem", 20.0); }, { "hem", "boundary" });
  refusals.refuse(
    "InvalidOption", grid, [](vtkPatternWriter& writer) { writer.SetFileName(nullptr); },
    { "no file name", "FileName" }, vtkErrorCode::NoFileNameError);
  refusals.refuse(
    "InvalidOption", grid, [](vtkPatternWriter& writer) { writer.SetFileName("pattern.png"); },
    { "pattern.png", ".svg, .pdf, .dxf, .csv, .plt, .json" },
    vtkErrorCode::UnrecognizedFileTypeError);

  const std::string nowhere = folder + "/no such folder/pattern.pdf";
  refusals.refuse(
    "FileNotWritten", grid, [&](vtkPatternWriter& writer) { writer.SetFileName(nowhere.c_str()); },
    { nowhere, "No such file", "name another file" }, vtkErrorCode::CannotOpenFileError);
  statusOfSuccess(checks, folder);
  return checks.result();
}
