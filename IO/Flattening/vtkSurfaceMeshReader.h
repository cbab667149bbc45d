// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceMeshReader
 * @brief read a surface from OBJ, PLY or OFF in double precision
 *
 * vtkOBJReader and vtkPLYReader give coordinates in single precision and split points along texture
 * seams. This reader keeps both as the file has them. Formats, by the extension of the file:
 *
 * | extension | what is read |
 * |---|---|
 * | .obj | `v`, `f`, `l`, `vt`; names of `g`, `o` and `usemtl`; a unit in a comment ("# units: mm") |
 * | .ply | ASCII and binary: `vertex` (x, y, z), `face` and `tristrips` |
 * | .off | ASCII OFF, COFF, NOFF, STOFF |
 *
 * Outputs:
 *
 * | port | what | arrays |
 * |---|---|---|
 * | 0 | the faces as polygons | cells: `PieceName` (string) where objects or groups name parts; field data: `LengthUnit` (string, "mm", "cm", "m" or "inch") where the file states it |
 * | 1 | the line elements of OBJ and the seams of SeamSource, over the same points | cells: `CurveType` (int, as vtkFeatureCurveAlgorithm::CurveTypes), `CurveName` (string), `KeyShape` (int) where a key curve is straight |
 *
 * A group or object "dart left" gives the lines below it type and name. Other formats have readers
 * in VTK: vtkXMLPolyDataReader, vtkPolyDataReader, vtkSTLReader, vtkGLTFReader.
 *
 * **Errors**: a missing, damaged or truncated file, another extension, a SeamSource that the file
 * says nothing of. One vtkErrorMacro names file, line, and remedy; GetErrorMessage() and
 * GetErrorCode() repeat it, RequestData() returns 0 and the outputs are empty.
 *
 * @code
 * vtkNew<vtkSurfaceMeshReader> reader;
 * reader->SetFileName("shirt.obj");
 * reader->SetSeamSourceToTextures();
 * vtkNew<vtkWireWarpingFilter> flat;
 * flat->SetInputConnection(0, reader->GetOutputPort(0));
 * flat->SetInputConnection(1, reader->GetOutputPort(1));
 * @endcode
 *
 * @warning A surface without triangles, with holes, or with triangles of no area is read as it is.
 *
 * @sa vtkFeatureCurveReader vtkWireWarpingFilter
 */
#ifndef vtkSurfaceMeshReader_h
#define vtkSurfaceMeshReader_h

#include "vtkIOFlatteningModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the message

class VTKIOFLATTENING_EXPORT vtkSurfaceMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceMeshReader* New();
  vtkTypeMacro(vtkSurfaceMeshReader, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Edges of the faces of an OBJ file that become seams.
  enum SeamSources
  {
    SEAMS_NONE = 0,  ///< none
    SEAMS_TEXTURES,  ///< where texture coordinates break
    SEAMS_MATERIALS, ///< between two materials
    SEAMS_GROUPS     ///< between two objects or groups
  };

  ///@{
  /**
   * Edges within the surface that become seams on port 1. Default: SEAMS_NONE.
   */
  vtkSetClampMacro(SeamSource, int, SEAMS_NONE, SEAMS_GROUPS);
  vtkGetMacro(SeamSource, int);
  const char* GetSeamSourceAsString() const;
  void SetSeamSourceToNone() { this->SetSeamSource(SEAMS_NONE); }
  void SetSeamSourceToTextures() { this->SetSeamSource(SEAMS_TEXTURES); }
  void SetSeamSourceToMaterials() { this->SetSeamSource(SEAMS_MATERIALS); }
  void SetSeamSourceToGroups() { this->SetSeamSource(SEAMS_GROUPS); }
  ///@}

  /**
   * Whether the extension of a file is one of those above; returns 1 or 0.
   */
  static int CanReadFile(const char* name);

  /**
   * Why the last run failed; empty after success.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkSurfaceMeshReader();
  ~vtkSurfaceMeshReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceMeshReader(const vtkSurfaceMeshReader&) = delete;
  void operator=(const vtkSurfaceMeshReader&) = delete;

  char* FileName = nullptr;
  int SeamSource = SEAMS_NONE;
  std::string ErrorMessage;
};

#endif
