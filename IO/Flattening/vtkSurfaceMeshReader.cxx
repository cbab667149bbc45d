// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceMeshReader.h"

#include "FaceSeams.h"
#include "InputError.h"
#include "PolyDataOutput.h"
#include "ReadSurface.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include "vtkFlatteningAlgorithm.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>

vtkStandardNewMacro(vtkSurfaceMeshReader);

namespace
{
bool isKnown(const std::string& extension)
{
  return extension == ".obj" || extension == ".ply" || extension == ".off";
}
}

//------------------------------------------------------------------------------
vtkSurfaceMeshReader::vtkSurfaceMeshReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkSurfaceMeshReader::~vtkSurfaceMeshReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
const char* vtkSurfaceMeshReader::GetSeamSourceAsString() const
{
  constexpr std::array<const char*, 4> words{ "None", "Textures", "Materials", "Groups" };
  return words[static_cast<std::size_t>(this->SeamSource)];
}

//------------------------------------------------------------------------------
int vtkSurfaceMeshReader::CanReadFile(const char* name)
{
  return name && isKnown(wirewarp::lowerCaseExtension(name)) ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkSurfaceMeshReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  using namespace wirewarp;
  const std::string path = this->FileName ? this->FileName : "";
  this->ErrorMessage = failureOf(path, [&] {
    if (!isKnown(lowerCaseExtension(path)))
    {
      checkedFileSize(path); // a missing file has no format
      throw InputError(
        path, "the extension is not .obj, .ply or .off; read other formats by VTK's readers");
    }
    SurfaceContents contents = readSurface(path);
    if (!contents.note.empty())
    {
      vtkWarningMacro(<< path << ": " << contents.note);
    }
    const vtkSmartPointer<vtkPolyData> read = polyDataOf(contents.surface);
    vtkPolyData* const surface = vtkPolyData::GetData(outputVector, 0);
    surface->ShallowCopy(read);
    vtkFlatteningAlgorithm::SetLengthUnitOf(surface, contents.unit);
    addSeams(static_cast<enum SeamSource>(this->SeamSource), contents);
    vtkPolyData* const curves = vtkPolyData::GetData(outputVector, 1);
    if (contents.curves.lines.size() > 0)
    {
      curves->ShallowCopy(polyDataOf(contents.curves, read->GetPoints()));
    }
    vtkFlatteningAlgorithm::SetLengthUnitOf(curves, contents.unit);
  });
  this->SetErrorCode(codeOf(path, this->ErrorMessage, this));
  return this->ErrorMessage.empty() ? 1 : 0; // the pipeline empties the outputs then
}

//------------------------------------------------------------------------------
void vtkSurfaceMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "SeamSource: " << this->GetSeamSourceAsString() << "\n";
}
