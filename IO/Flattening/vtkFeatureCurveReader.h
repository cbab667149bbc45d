// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveReader
 * @brief read feature curves from a text, a table, a drawing or the lines of an OBJ file
 *
 * Formats, by the extension of the file:
 *
 * | extension | what is read |
 * |---|---|
 * | .csv | a point a row: columns `name`, `x`, `y`, `z` and `type` in any order, divided by comma, semicolon or tab |
 * | .dxf | ASCII: LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE, SPLINE; a layer "dart left" gives type and name |
 * | .obj | line elements `l`; a group or object "dart left" gives type and name |
 * | another | text, a curve a line: TYPE NAME v0 v1 ... with ids of the surface's points, or points as x,y,z |
 *
 * A type is accessory, key, straight (a key curve that is straight in the plane), dart or seam. In
 * texts and tables it may also be edge: an accessory curve that follows the boundary from each of
 * its vertices to the next, the shorter way; points of it may miss the boundary by 0.5 % of the
 * size of the surface. Instead of points, in a table in the column x, may stand `plane x=0`,
 * `opening 2`, `boundary left` or `between waist and hem`, as `wirewarp formats` explains.
 * Coordinates are in the unit of the surface. Polylines in the formats of VTK are read by
 * vtkXMLPolyDataReader and vtkPolyDataReader.
 *
 * Inputs and output:
 *
 * | port | what | arrays |
 * |---|---|---|
 * | input 0 | the surface, for texts and for edges; optional otherwise | |
 * | output 0 | polylines | cells: `CurveType` (int, as vtkFeatureCurveAlgorithm::CurveTypes), `CurveName` (string), `KeyShape` (int) where a key curve is straight; field data: `LengthUnit` where the file states it |
 *
 * **Errors**: a missing, damaged or truncated file, an unknown type, an id that the surface does
 * not have, an edge off the boundary, no surface where one is needed. One vtkErrorMacro names file,
 * line, and remedy; GetErrorMessage() and GetErrorCode() repeat it, RequestData() returns 0 and the
 * output is empty.
 *
 * @code
 * vtkNew<vtkFeatureCurveReader> reader;
 * reader->SetInputData(surface);
 * reader->SetFileName("darts.dxf");
 * vtkNew<vtkWireWarpingFilter> flat;
 * flat->SetInputData(0, surface);
 * flat->SetInputConnection(1, reader->GetOutputPort());
 * @endcode
 *
 * @warning The file may be from anywhere; its curves may lie off the surface. vtkWireWarpingFilter
 * measures that and names the curve.
 *
 * @sa vtkSurfaceMeshReader vtkFeatureCurveEditor vtkWireWarpingFilter
 */
#ifndef vtkFeatureCurveReader_h
#define vtkFeatureCurveReader_h

#include "vtkIOFlatteningModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the messages

class VTKIOFLATTENING_EXPORT vtkFeatureCurveReader : public vtkPolyDataAlgorithm
{
public:
  static vtkFeatureCurveReader* New();
  vtkTypeMacro(vtkFeatureCurveReader, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * What the last run left out of a drawing (texts and points apart), with a remedy; empty where
   * nothing was. It is also a vtkWarningMacro.
   */
  const char* GetNote() const { return this->Note.c_str(); }

  /**
   * Why the last run failed; empty after success.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkFeatureCurveReader();
  ~vtkFeatureCurveReader() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFeatureCurveReader(const vtkFeatureCurveReader&) = delete;
  void operator=(const vtkFeatureCurveReader&) = delete;

  char* FileName = nullptr;
  std::string Note;
  std::string ErrorMessage;
};

#endif
