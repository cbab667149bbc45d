// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternWriter.h"

#include "Base/Memory.h"
#include "FairCache.h"
#include "FileAside.h"
#include "GradingData.h"
#include "PatternFile.h"
#include "PatternInput.h"
#include "RemedyWords.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkErrorCode.h"
#include "vtkFeatureCurveAlgorithm.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <cstdlib>
#include <ctime>

vtkStandardNewMacro(vtkPatternWriter);

namespace
{
namespace pattern = flattening::pattern;
using flattening::Status;
using flattening::StatusCode;

/// The day and minute, UTC. SOURCE_DATE_EPOCH makes files that can be made again bit for bit.
void setTime(pattern::Pattern& drawing)
{
  std::time_t now = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH"))
  {
    now = static_cast<std::time_t>(std::strtoll(epoch, nullptr, 10));
  }
  std::tm parts{};
#ifdef _WIN32
  const bool known = gmtime_s(&parts, &now) == 0;
#else
  const bool known = gmtime_r(&now, &parts) != nullptr;
#endif
  char text[32];
  if (known && std::strftime(text, sizeof text, "%Y-%m-%d%H:%M", &parts) == 15)
  {
    drawing.date.assign(text, 10);
    drawing.time.assign(text + 10, 5);
  }
}

/// The filter whose first output came here unchanged; null where there is none.
vtkAlgorithm* flatteningBehind(vtkAlgorithmOutput* connection)
{
  while (connection)
  {
    vtkAlgorithm* const producer = connection->GetProducer();
    if (vtkFeatureCurveAlgorithm::SafeDownCast(producer))
    {
      return producer->GetNumberOfOutputPorts() >= 3 && connection->GetIndex() == 0 ? producer
                                                                                    : nullptr;
    }
    const bool handsOn =
      producer->GetNumberOfInputPorts() == 1 && producer->GetNumberOfInputConnections(0) == 1;
    connection = handsOn ? producer->GetInputConnection(0, 0) : nullptr;
  }
  return nullptr;
}

unsigned long errorCodeOf(StatusCode code)
{
  return code == StatusCode::FileNotWritten ? vtkErrorCode::CannotOpenFileError
                                            : vtkErrorCode::UserError;
}
}

//------------------------------------------------------------------------------
vtkPatternWriter::vtkPatternWriter()
  : Fair(std::make_unique<pattern::FairCache>())
{
  this->SetNumberOfInputPorts(4);
}

//------------------------------------------------------------------------------
vtkPatternWriter::~vtkPatternWriter() = default;

//------------------------------------------------------------------------------
int vtkPatternWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port > 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetWarning(int warning) const
{
  return warning >= 0 && warning < this->GetNumberOfWarnings()
    ? this->Warnings[static_cast<std::size_t>(warning)].c_str()
    : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetNote(int note) const
{
  return note >= 0 && note < this->GetNumberOfNotes()
    ? this->Notes[static_cast<std::size_t>(note)].first.c_str()
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkPatternWriter::GetNoteKind(int note) const
{
  return note >= 0 && note < this->GetNumberOfNotes()
    ? this->Notes[static_cast<std::size_t>(note)].second
    : static_cast<int>(DRAWN);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkPatternWriter::DataOf(int port)
{
  if (this->GetNumberOfInputConnections(port) > 0)
  {
    return vtkPolyData::SafeDownCast(this->GetInput(port));
  }
  vtkAlgorithm* const flattening = this->FollowPipeline && this->GetNumberOfInputConnections(0) > 0
    ? flatteningBehind(this->GetInputConnection(0, 0))
    : nullptr;
  auto* const flat = vtkPolyData::SafeDownCast(flattening ? this->GetInput(0) : nullptr);
  auto* const made =
    vtkPolyData::SafeDownCast(flattening ? flattening->GetOutputDataObject(0) : nullptr);
  // Ids of points hold only as long as nobody has changed these.
  const bool same = flat && made && flat->GetPoints() == made->GetPoints() &&
    flat->GetNumberOfCells() == made->GetNumberOfCells();
  return same ? vtkPolyData::SafeDownCast(flattening->GetOutputDataObject(port)) : nullptr;
}

//------------------------------------------------------------------------------
Status vtkPatternWriter::WritePattern(int format)
{
  pattern::PatternSource source;
  Status status =
    flattening::bridge::readPattern(this->DataOf(0), this->DataOf(1), this->DataOf(2), source);
  pattern::FileOptions options = this->MakeOptions(format);
  options.pattern.unit = static_cast<pattern::Unit>(this->KnownUnit());
  pattern::Grading grading;
  if (status.ok() && this->GetNumberOfInputConnections(3) > 0)
  {
    status = flattening::bridge::readGrading(vtkPolyData::SafeDownCast(this->GetInput(3)), grading);
    options.grading = &grading;
  }
  options.fair = this->Fair.get();
  pattern::Pattern drawing;
  setTime(drawing);
  std::string content;
  if (status.ok())
  {
    status = pattern::makePatternFile(source, options, drawing, content);
  }
  if (status.ok())
  {
    pattern::FileAside file(this->FileName);
    status = file.write(content);
    if (status.ok())
    {
      status = file.publish();
    }
  }
  if (status.ok())
  {
    this->FabricLength = drawing.fabric ? drawing.fabric->length : 0.0;
    this->FabricEfficiency = drawing.fabric ? drawing.fabric->efficiency : 0.0;
    for (const pattern::PatternPiece& piece : drawing.pieces)
    {
      this->Warnings.insert(this->Warnings.end(), piece.warnings.begin(), piece.warnings.end());
      for (const pattern::PatternNote& note : piece.notes)
      {
        this->Notes.emplace_back(note.text, static_cast<int>(note.kind));
      }
    }
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkPatternWriter::WriteData()
{
  this->Keep({});
  this->Warnings.clear();
  this->Notes.clear();
  this->FabricLength = 0.0;
  this->FabricEfficiency = 0.0;
  if (!this->FileName || !*this->FileName)
  {
    this->Refuse(vtkErrorCode::NoFileNameError,
      { StatusCode::InvalidOption, "there is no file name", {},
        { { flattening::Remedy::Give, "FileName" } } });
    return;
  }
  const int format = this->ChosenFormat();
  if (format == AUTOMATIC)
  {
    this->Refuse(vtkErrorCode::UnrecognizedFileTypeError,
      { StatusCode::InvalidOption,
        std::string(this->FileName) + " ends with none of " + pattern::knownExtensions(), {},
        { flattening::Remedy::NameAnotherFile } });
    return;
  }
  struct Ending
  {
    Status status;
  };
  const Status status =
    flattening::withinMemory([&] { return Ending{ this->WritePattern(format) }; }).status;
  if (!status.ok())
  {
    this->Refuse(errorCodeOf(status.code), status);
    return;
  }
  for (const std::string& warning : this->Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (this->KnownUnit() == UNSPECIFIED)
  {
    vtkWarningMacro("The unit of the surface is not stated: it is taken as cm. Set Unit.");
  }
}
