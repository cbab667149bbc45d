// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternFileWriter.h"

#include "Formats/PatternFile.h"
#include "RemedyWords.h"

#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

//------------------------------------------------------------------------------
vtkPatternFileWriter::vtkPatternFileWriter()
  : StatusRemedies(vtkSmartPointer<vtkStringArray>::New())
  , StatusRemedySubjects(vtkSmartPointer<vtkStringArray>::New())
{
}

//------------------------------------------------------------------------------
vtkPatternFileWriter::~vtkPatternFileWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
const char* vtkPatternFileWriter::GetFileFormatAsString() const
{
  return flattening::pattern::formatName(
    static_cast<flattening::pattern::FileFormat>(this->FileFormat));
}

//------------------------------------------------------------------------------
const char* vtkPatternFileWriter::GetPaperAsString() const
{
  return flattening::pattern::paperName(static_cast<flattening::pattern::PaperSize>(this->Paper));
}

//------------------------------------------------------------------------------
int vtkPatternFileWriter::ChosenFormat() const
{
  return this->FileFormat != AUTOMATIC
    ? this->FileFormat
    : static_cast<int>(flattening::pattern::formatOf(this->FileName));
}

//------------------------------------------------------------------------------
vtkStringArray* vtkPatternFileWriter::GetStatusRemedies() const
{
  return this->StatusRemedies;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkPatternFileWriter::GetStatusRemedySubjects() const
{
  return this->StatusRemedySubjects;
}

//------------------------------------------------------------------------------
void vtkPatternFileWriter::Keep(const flattening::Status& status)
{
  this->StatusName = flattening::statusName(status.code);
  this->StatusDefect = status.message;
  this->ErrorMessage = flattening::bridge::inWords(status);
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
void vtkPatternFileWriter::Refuse(unsigned long code, const flattening::Status& status)
{
  this->Keep(status);
  this->SetErrorCode(code);
  vtkErrorMacro(<< this->ErrorMessage);
}

//------------------------------------------------------------------------------
void vtkPatternFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FileFormat: " << this->GetFileFormatAsString() << "\n";
  os << indent << "LaserColors: " << (this->LaserColors ? "On" : "Off") << "\n";
  os << indent << "Paper: " << this->GetPaperAsString() << "\n";
  os << indent << "PageOverlap: " << this->PageOverlap << "\n";
  os << indent << "MaximumPages: " << this->MaximumPages << "\n";
  os << indent << "WalkTable: " << (this->WalkTable ? "On" : "Off") << "\n";
  os << indent << "Status: " << this->StatusName << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
