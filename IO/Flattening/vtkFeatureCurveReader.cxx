// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureCurveReader.h"

#include "InputError.h"
#include "PolyDataOutput.h"
#include "ReadCurves.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkFeatureCurveReader);

//------------------------------------------------------------------------------
vtkFeatureCurveReader::vtkFeatureCurveReader()
{
  this->SetNumberOfInputPorts(1);
}

//------------------------------------------------------------------------------
vtkFeatureCurveReader::~vtkFeatureCurveReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveReader::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkFeatureCurveReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using namespace wirewarp;
  this->Note.clear();
  const std::string path = this->FileName ? this->FileName : "";
  this->ErrorMessage = failureOf(path, [&] {
    const std::string extension = lowerCaseExtension(path);
    if (extension == ".vtp" || extension == ".vtk")
    {
      checkedFileSize(path); // a missing file has no format
      throw InputError(
        path, "polylines of VTK are read by vtkXMLPolyDataReader or vtkPolyDataReader");
    }
    vtkPolyData* const surface = vtkPolyData::GetData(inputVector[0], 0);
    const bool isText = extension != ".obj" && extension != ".csv" && extension != ".dxf";
    if (isText && (!surface || surface->GetNumberOfPoints() == 0))
    {
      checkedFileSize(path);
      throw InputError(path, "ids of points need the surface that has them; give it as input 0");
    }
    const DataSet ids = surface ? dataSetOf(surface) : DataSet();
    const CurveContents contents = readCurves(path, ids);
    this->Note = contents.note;
    const bool same = contents.curves.points == ids.points;
    vtkPolyData::GetData(outputVector, 0)
      ->ShallowCopy(polyDataOf(contents.curves, surface && same ? surface->GetPoints() : nullptr));
  });
  this->SetErrorCode(codeOf(path, this->ErrorMessage, this));
  if (!this->ErrorMessage.empty())
  {
    return 0; // the pipeline empties the outputs
  }
  if (!this->Note.empty())
  {
    vtkWarningMacro(<< path << ": " << this->Note);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkFeatureCurveReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
