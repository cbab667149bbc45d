// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternWriter.h"

#include "Base/Memory.h"
#include "Drawing/PatternBuilder.h"
#include "Fairing/FairBorders.h"
#include "Formats/PatternData.h"
#include "Formats/PatternFile.h"
#include "Formats/PatternOptionTable.h"
#include "Input/StatusWords.h"
#include "ListChanges.h"
#include "OptionProperties.h"
#include "PatternInput.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkFeatureCurveAlgorithm.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <variant>

vtkStandardNewMacro(vtkPatternWriter);

namespace
{
namespace pattern = flattening::pattern;
using flattening::Status;
using flattening::StatusCode;

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

double valueOf(
  const std::map<std::string, double>& ofCurve, const std::string& curve, double common)
{
  const auto found = ofCurve.find(curve);
  return found == ofCurve.end() ? common : found->second;
}
}

//------------------------------------------------------------------------------
vtkPatternWriter::vtkPatternWriter()
  : Options(std::make_unique<flattening::OptionValues>(pattern::patternOptions()))
  , Lists(std::make_unique<pattern::PatternOptions>())
  , Fair(std::make_unique<pattern::FairCache>())
  , StatusRemedies(vtkSmartPointer<vtkStringArray>::New())
  , StatusRemedySubjects(vtkSmartPointer<vtkStringArray>::New())
{
  this->SetNumberOfInputPorts(4);
}

//------------------------------------------------------------------------------
vtkPatternWriter::~vtkPatternWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetFileFormatAsString() const
{
  return flattening::pattern::formatName(
    static_cast<flattening::pattern::FileFormat>(this->FileFormat));
}

//------------------------------------------------------------------------------
void vtkPatternWriter::SetNumberOption(const char* property, double value)
{
  flattening::bridge::setNumber(this, *this->Options, property, value);
}

//------------------------------------------------------------------------------
double vtkPatternWriter::GetNumberOption(const char* property) const
{
  return this->Options->number(property);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::SetTextOption(const char* property, const char* text)
{
  flattening::bridge::setText(this, *this->Options, property, text ? text : "");
}

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetTextOption(const char* property) const
{
  return std::get<std::string>((*this->Options)[property]).c_str();
}

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetOptionWord(const char* property) const
{
  return flattening::bridge::nameOfWord(*this->Options, property);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::SetOptions(const flattening::OptionValues& values)
{
  *this->Options = values;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPatternWriter::GetOptions(flattening::OptionValues& values)
{
  values = *this->Options;
}

//------------------------------------------------------------------------------
int vtkPatternWriter::ChosenFormat() const
{
  return this->FileFormat != AUTOMATIC
    ? this->FileFormat
    : static_cast<int>(flattening::pattern::formatOf(this->FileName));
}

//------------------------------------------------------------------------------
vtkStringArray* vtkPatternWriter::GetStatusRemedies() const
{
  return this->StatusRemedies;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkPatternWriter::GetStatusRemedySubjects() const
{
  return this->StatusRemedySubjects;
}

//------------------------------------------------------------------------------
void vtkPatternWriter::Keep(const flattening::Status& status)
{
  this->StatusName = flattening::statusName(status.code);
  this->StatusDefect = status.message;
  this->ErrorMessage = flattening::inWords(status);
  // New arrays: the caller may have kept those of the last run.
  this->StatusRemedies = vtkSmartPointer<vtkStringArray>::New();
  this->StatusRemedySubjects = vtkSmartPointer<vtkStringArray>::New();
  for (const flattening::SuggestedRemedy& suggested : status.remedies)
  {
    this->StatusRemedies->InsertNextValue(flattening::remedyName(suggested.remedy));
    this->StatusRemedySubjects->InsertNextValue(suggested.subject);
  }
}

//------------------------------------------------------------------------------
void vtkPatternWriter::Refuse(unsigned long code, const flattening::Status& status)
{
  this->Keep(status);
  this->SetErrorCode(code);
  vtkErrorMacro(<< this->ErrorMessage);
}

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
  static_assert(static_cast<int>(flattening::Unit::Unspecified) == UNSPECIFIED, "");
  static_assert(static_cast<int>(flattening::Unit::Inch) == INCH, "");
  static_assert(static_cast<int>(pattern::FileFormat::Automatic) == AUTOMATIC, "");
  static_assert(static_cast<int>(pattern::FileFormat::GarmentCode) == GARMENT_CODE, "");
  static_assert(static_cast<int>(pattern::FileFormat::RuleTable) == RULE_TABLE, "");
  pattern::PatternSource source;
  Status status =
    flattening::bridge::readPieces(this->DataOf(0), this->DataOf(1), this->DataOf(2), source);
  pattern::FileOptions options;
  options.format = static_cast<pattern::FileFormat>(format);
  options.pattern = *this->Lists;
  options.pattern.unit = static_cast<flattening::Unit>(this->KnownUnit());
  pattern::setOptions(*this->Options, options);
  pattern::Grading grading;
  if (status.ok() && this->GetNumberOfInputConnections(3) > 0)
  {
    status = flattening::bridge::readGrading(vtkPolyData::SafeDownCast(this->GetInput(3)), grading);
    options.grading = &grading;
  }
  options.fair = this->Fair.get();
  pattern::Pattern drawing;
  if (status.ok())
  {
    status = pattern::writePattern(this->FileName, source, options, drawing);
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
  const Status status = flattening::withinMemory([&] { return this->WritePattern(format); });
  if (!status.ok())
  {
    this->Refuse(status.code == StatusCode::FileNotWritten ? vtkErrorCode::CannotOpenFileError
                                                           : vtkErrorCode::UserError,
      status);
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

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetUnitAsString() const
{
  static const char* const names[] = { "Unspecified", "Millimetre", "Centimetre", "Metre", "Inch" };
  return names[this->Unit];
}

//------------------------------------------------------------------------------
bool vtkPatternWriter::SetUnitByName(const std::string& name)
{
  const flattening::Unit unit = flattening::unitNamed(name);
  if (unit != flattening::Unit::Unspecified)
  {
    this->SetUnit(static_cast<int>(unit));
    return true;
  }
  vtkErrorMacro("Unknown unit '" << name << "'; there are mm, cm, m and inch.");
  return false;
}

//------------------------------------------------------------------------------
int vtkPatternWriter::KnownUnit()
{
  return this->Unit != UNSPECIFIED ? this->Unit
                                   : static_cast<int>(flattening::unitNamed(
                                       vtkFlatteningAlgorithm::GetLengthUnitOf(this->DataOf(0))));
}

//------------------------------------------------------------------------------
void vtkPatternWriter::SetPieceName(int piece, const std::string& name)
{
  if (piece < 0 || piece > 1000000)
  {
    vtkErrorMacro("There can be no piece " << piece << "; pieces are counted from 0.");
    return;
  }
  const std::size_t index = static_cast<std::size_t>(piece);
  if (this->Lists->pieceNames.size() <= index)
  {
    this->Lists->pieceNames.resize(index + 1);
  }
  flattening::bridge::change(this, this->Lists->pieceNames[index], name);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::SetPieceQuantity(int piece, int quantity)
{
  if (piece < 0 || piece > 1000000 || quantity < 0)
  {
    vtkErrorMacro("There can be no piece " << piece << " of which " << quantity
                                           << " are cut; both are counted from 0.");
    return;
  }
  const auto index = static_cast<std::size_t>(piece);
  if (this->Lists->pieceQuantities.size() <= index)
  {
    this->Lists->pieceQuantities.resize(index + 1, 0);
  }
  flattening::bridge::change(this, this->Lists->pieceQuantities[index], quantity);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::RemoveAllPieceQuantities()
{
  flattening::bridge::changeToNone(this, this->Lists->pieceQuantities);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::RemoveAllPieceNames()
{
  flattening::bridge::changeToNone(this, this->Lists->pieceNames);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::AddCurveNotch(const std::string& curve, double distance)
{
  this->Lists->notchesOfCurve[curve].push_back(distance);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPatternWriter::GetNumberOfCurveNotches(const std::string& curve) const
{
  const auto found = this->Lists->notchesOfCurve.find(curve);
  return found == this->Lists->notchesOfCurve.end() ? 0 : static_cast<int>(found->second.size());
}

//------------------------------------------------------------------------------
double vtkPatternWriter::GetCurveNotch(const std::string& curve, int notch) const
{
  if (notch < 0 || notch >= this->GetNumberOfCurveNotches(curve))
  {
    vtkErrorMacro("The curve '" << curve << "' has no notch " << notch << " of its own.");
    return 0.0;
  }
  return this->Lists->notchesOfCurve.at(curve)[static_cast<std::size_t>(notch)];
}

//------------------------------------------------------------------------------
void vtkPatternWriter::RemoveAllCurveNotches()
{
  flattening::bridge::changeToNone(this, this->Lists->notchesOfCurve);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::AddDoubleNotches(const std::string& curve)
{
  if (this->Lists->doubleNotches.insert(curve).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkPatternWriter::HasDoubleNotches(const std::string& curve) const
{
  return this->Lists->doubleNotches.count(curve) > 0;
}

//------------------------------------------------------------------------------
void vtkPatternWriter::RemoveAllDoubleNotches()
{
  flattening::bridge::changeToNone(this, this->Lists->doubleNotches);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::AddFold(const std::string& curve)
{
  if (this->Lists->foldsAlong.insert(curve).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPatternWriter::RemoveAllFolds()
{
  flattening::bridge::changeToNone(this, this->Lists->foldsAlong);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkStringArray> vtkPatternWriter::GetCurvesWithOptions() const
{
  auto list = vtkSmartPointer<vtkStringArray>::New();
  for (const std::string& name : pattern::curvesWithOptions(*this->Lists))
  {
    list->InsertNextValue(name);
  }
  return list;
}

//------------------------------------------------------------------------------
void vtkPatternWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FileFormat: " << this->GetFileFormatAsString() << "\n";
  flattening::bridge::print(*this->Options, os, indent);
  os << indent << "Status: " << this->StatusName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "Unit: " << this->GetUnitAsString() << "\n";
  for (std::size_t p = 0; p < this->Lists->pieceQuantities.size(); ++p)
  {
    os << indent << "PieceQuantity " << p << ": " << this->Lists->pieceQuantities[p] << "\n";
  }
  for (std::size_t p = 0; p < this->Lists->pieceNames.size(); ++p)
  {
    os << indent << "PieceName " << p << ": " << this->Lists->pieceNames[p] << "\n";
  }
  const auto printLengths = [&](const char* name, const std::map<std::string, double>& lengths) {
    for (const auto& [curve, length] : lengths)
    {
      os << indent << name << " " << curve << ": " << length << "\n";
    }
  };
  printLengths("CurveAllowance", this->Lists->allowanceOfCurve);
  for (const auto& [curve, distances] : this->Lists->notchesOfCurve)
  {
    os << indent << "CurveNotches " << curve << ":";
    for (const double distance : distances)
    {
      os << " " << distance;
    }
    os << "\n";
  }
  for (const std::string& curve : this->Lists->doubleNotches)
  {
    os << indent << "DoubleNotches: " << curve << "\n";
  }
  for (const std::string& curve : this->Lists->foldsAlong)
  {
    os << indent << "Fold: " << curve << "\n";
  }
  printLengths("CurveDartTip", this->Lists->dartTipOfCurve);
  printLengths("CurveFairTolerance", this->Lists->fairToleranceOfCurve);
  os << indent << "FabricLength: " << this->FabricLength << "\n";
  os << indent << "FabricEfficiency: " << this->FabricEfficiency << "\n";
  os << indent << "FollowPipeline: " << (this->FollowPipeline ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
// Lengths of single curves, in place of that of all others.
#define curveLengths(name, all, list)                                                              \
  void vtkPatternWriter::SetCurve##name(const std::string& curve, double length)                   \
  {                                                                                                \
    flattening::bridge::changeEntry(this, this->Lists->list, curve, length);                       \
  }                                                                                                \
  double vtkPatternWriter::GetCurve##name(const std::string& curve) const                          \
  {                                                                                                \
    return valueOf(this->Lists->list, curve, this->Get##name());                                   \
  }                                                                                                \
  bool vtkPatternWriter::HasCurve##name(const std::string& curve) const                            \
  {                                                                                                \
    return this->Lists->list.count(curve) > 0;                                                     \
  }                                                                                                \
  void vtkPatternWriter::RemoveAllCurve##all()                                                     \
  {                                                                                                \
    flattening::bridge::changeToNone(this, this->Lists->list);                                     \
  }
// clang-format off
curveLengths(Allowance, Allowances, allowanceOfCurve)
curveLengths(DartTip, DartTips, dartTipOfCurve)
curveLengths(FairTolerance, FairTolerances, fairToleranceOfCurve)
// clang-format on
#undef curveLengths
