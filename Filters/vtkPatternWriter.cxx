// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternWriter.h"

#include "DxfWriter.h"
#include "FileAside.h"
#include "PatternBuilder.h"
#include "PatternInput.h"
#include "PdfWriter.h"
#include "SvgWriter.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <ctime>

vtkStandardNewMacro(vtkPatternWriter);

namespace
{
namespace pattern = flattening::pattern;

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

unsigned long errorCodeOf(pattern::PatternCode code)
{
  return code == pattern::PatternCode::CannotWrite ? vtkErrorCode::CannotOpenFileError
                                                   : vtkErrorCode::UserError;
}
}

//------------------------------------------------------------------------------
vtkPatternWriter::vtkPatternWriter()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
vtkPatternWriter::~vtkPatternWriter()
{
  this->SetFileName(nullptr);
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
const char* vtkPatternWriter::GetFileFormatAsString() const
{
  static const char* const names[] = { "Automatic", "SVG", "PDF", "DXF" };
  return names[this->FileFormat];
}

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetUnitAsString() const
{
  static const char* const names[] = { "Unspecified", "Millimetre", "Centimetre", "Metre", "Inch" };
  return names[this->Unit];
}

//------------------------------------------------------------------------------
const char* vtkPatternWriter::GetPaperAsString() const
{
  return pattern::paperName(static_cast<pattern::PaperSize>(this->Paper));
}

//------------------------------------------------------------------------------
bool vtkPatternWriter::SetUnitByName(const std::string& name)
{
  for (const int unit : { MILLIMETRE, CENTIMETRE, METRE, INCH })
  {
    if (name == pattern::unitName(static_cast<pattern::Unit>(unit)))
    {
      this->SetUnit(unit);
      return true;
    }
  }
  vtkErrorMacro("Unknown unit '" << name << "'; there are mm, cm, m and inch.");
  return false;
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
  if (this->PieceNames.size() <= index)
  {
    this->PieceNames.resize(index + 1);
  }
  this->PieceNames[index] = name;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPatternWriter::RemoveAllPieceNames()
{
  this->PieceNames.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPatternWriter::SetCurveAllowance(const std::string& curve, double allowance)
{
  this->CurveAllowances[curve] = allowance;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPatternWriter::RemoveAllCurveAllowances()
{
  this->CurveAllowances.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPatternWriter::ChosenFormat() const
{
  if (this->FileFormat != AUTOMATIC)
  {
    return this->FileFormat;
  }
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(this->FileName));
  return extension == ".svg" ? SVG
    : extension == ".pdf"    ? PDF
    : extension == ".dxf"    ? DXF
                             : AUTOMATIC;
}

//------------------------------------------------------------------------------
flattening::pattern::PatternOptions vtkPatternWriter::MakeOptions() const
{
  static_assert(static_cast<int>(pattern::Unit::Unspecified) == UNSPECIFIED, "");
  static_assert(static_cast<int>(pattern::Unit::Inch) == INCH, "");
  pattern::PatternOptions options;
  options.unit = static_cast<pattern::Unit>(this->Unit);
  options.name = this->PatternName;
  options.size = this->PatternSize;
  options.quantity = this->Quantity;
  options.pieceNames = this->PieceNames;
  options.allowance = this->Allowance;
  options.allowanceOfCurve = this->CurveAllowances;
  options.mitreLimit = this->MitreLimit;
  options.notchSpacing = this->NotchSpacing;
  options.notchLength = this->NotchLength;
  options.darts = this->CutDartsOut ? pattern::DartStyle::CutOut : pattern::DartStyle::Folded;
  return options;
}

//------------------------------------------------------------------------------
void vtkPatternWriter::Refuse(unsigned long code, const std::string& message)
{
  this->ErrorMessage = message;
  this->SetErrorCode(code);
  vtkErrorMacro(<< message);
}

//------------------------------------------------------------------------------
void vtkPatternWriter::WriteData()
{
  this->ErrorMessage.clear();
  if (!this->FileName || !*this->FileName)
  {
    this->Refuse(vtkErrorCode::NoFileNameError, "a file name is needed; set FileName");
    return;
  }
  const int format = this->ChosenFormat();
  if (format == AUTOMATIC)
  {
    this->Refuse(vtkErrorCode::UnrecognizedFileTypeError,
      std::string(this->FileName) +
        " ends with none of .svg, .pdf, .dxf; name it so, or set FileFormat");
    return;
  }
  const auto data = [this](int port) {
    return this->GetNumberOfInputConnections(port) > 0
      ? vtkPolyData::SafeDownCast(this->GetInput(port))
      : nullptr;
  };
  pattern::PatternSource source;
  pattern::PatternStatus status =
    flattening::bridge::readPattern(data(0), data(1), data(2), source);
  pattern::Pattern drawing;
  if (status.ok())
  {
    status = pattern::buildPattern(source, this->MakeOptions(), drawing);
  }
  std::string content;
  if (status.ok())
  {
    setTime(drawing);
    if (format == PDF)
    {
      static_assert(static_cast<int>(pattern::PaperSize::A0) == A0, "");
      static_assert(static_cast<int>(pattern::PaperSize::Sheet) == SHEET, "");
      pattern::PageOptions pages;
      pages.paper = static_cast<pattern::PaperSize>(this->Paper);
      pages.overlap = this->PageOverlap;
      pages.maximumPages = this->MaximumPages;
      status = pattern::makePdf(drawing, pages, content);
    }
    else
    {
      content = format == SVG ? pattern::makeSvg(drawing) : pattern::makeDxf(drawing);
    }
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
  if (!status.ok())
  {
    this->Refuse(errorCodeOf(status.code), status.message);
    return;
  }
  if (this->Unit == UNSPECIFIED)
  {
    vtkWarningMacro("The unit of the surface is not stated: it is taken as cm. Set Unit.");
  }
}

//------------------------------------------------------------------------------
void vtkPatternWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FileFormat: " << this->GetFileFormatAsString() << "\n";
  os << indent << "Unit: " << this->GetUnitAsString() << "\n";
  os << indent << "PatternName: " << this->PatternName << "\n";
  os << indent << "PatternSize: " << this->PatternSize << "\n";
  os << indent << "Quantity: " << this->Quantity << "\n";
  for (std::size_t p = 0; p < this->PieceNames.size(); ++p)
  {
    os << indent << "PieceName " << p << ": " << this->PieceNames[p] << "\n";
  }
  os << indent << "Allowance: " << this->Allowance << "\n";
  for (const auto& entry : this->CurveAllowances)
  {
    os << indent << "CurveAllowance " << entry.first << ": " << entry.second << "\n";
  }
  os << indent << "MitreLimit: " << this->MitreLimit << "\n";
  os << indent << "NotchSpacing: " << this->NotchSpacing << "\n";
  os << indent << "NotchLength: " << this->NotchLength << "\n";
  os << indent << "CutDartsOut: " << (this->CutDartsOut ? "On" : "Off") << "\n";
  os << indent << "Paper: " << this->GetPaperAsString() << "\n";
  os << indent << "PageOverlap: " << this->PageOverlap << "\n";
  os << indent << "MaximumPages: " << this->MaximumPages << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
