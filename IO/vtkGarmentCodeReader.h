// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGarmentCodeReader
 * @brief read a sewing pattern of GarmentCode: panels as flat pieces with seams
 *
 * The JSON of GarmentCode (M. Korosteleva, O. Sorkine-Hornung, ACM Transactions on Graphics 42(6),
 * 2023) holds panels with straight, quadratic, cubic and circular edges, stitches between edges,
 * and where each panel is in space. Outputs are those of vtkWireWarpingFilter, in centimetres, and
 * so vtkPatternWriter draws them:
 *
 * | port | what | arrays |
 * |---|---|---|
 * | 0 | the panels as flat pieces, triangles between points of their borders | cells: `PieceId`; field data: `SeamPairs` (points a, b, c, d and the curve: edge ab to edge cd, a to c) |
 * | 1 | their borders as polylines over the same points | cells: `CurveType` (-1 boundary, 0 accessory, 2 dart, 3 seam), `WireKind` the same, `CurveId`, `CurveName`, `PieceId`, `Boundary` (1), `Connector` (0), `RestLength`, `FlatLength`, `LengthError` (0); field data as below |
 * | 2 | the same triangles where the panels are placed in space | cells: `PieceId` |
 *
 * Curved edges are chords within 0.02 mm of them, as many on both edges of a stitch and of one
 * length each. Edges that are sewn together one after the other under one label are one seam, or a
 * dart where its sides meet in a point, named by the label, or "stitch N" where both have none.
 * Other edges with a label are accessory curves of that name, so that hems have allowances of their
 * own.
 *
 * The field data of port 1 says what the file said, one row for each panel in `PanelNames`,
 * `PanelLabels` and `PanelPlacements` (translation; degrees about x, y and z), for each edge in
 * `PanelEdges`
 * (piece, first and last point, shape: 0 straight, 1 quadratic, 2 cubic, 3 circle),
 * `PanelEdgeParameters` (control points in the frame of the chord; radius, larger arc,
 * counter-clockwise) and `PanelEdgeLabels`, for each stitch in `PanelStitches` (two edges, and 1
 * where it runs from start to start). vtkPatternWriter writes these again: panels, edges and
 * stitches of the new file are equal to those of the old. Parameters of a design are not kept.
 *
 * Panels whose borders run clockwise are kept as they are, with triangles counter-clockwise.
 *
 * **Errors**: no file; no JSON; a panel whose edges are no ring, have no length, or cross; an arc
 * that does not reach its ends; stitches of edges that are not there, or of one edge with two. One
 * vtkErrorMacro names panel and edge, GetStatusName() ("InvalidPattern", "NothingToDraw"),
 * GetErrorMessage() and GetErrorCode() tell it again, and the outputs are empty.
 *
 * @code
 * vtkNew<vtkGarmentCodeReader> reader;
 * reader->SetFileName("dress_specification.json");
 * vtkNew<vtkPatternWriter> writer;
 * for (int port = 0; port < 3; ++port)
 * {
 *   writer->SetInputConnection(port, reader->GetOutputPort(port));
 * }
 * writer->SetUnitToCentimetre();
 * writer->SetFileName("dress.pdf");
 * writer->Write();
 * @endcode
 *
 * @warning Flat pieces have points on their borders alone: they are for patterns, not for cloth
 * simulation.
 *
 * @sa vtkPatternWriter
 */
#ifndef vtkGarmentCodeReader_h
#define vtkGarmentCodeReader_h

#include "vtkIOPatternModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the message

class VTKIOPATTERN_EXPORT vtkGarmentCodeReader : public vtkPolyDataAlgorithm
{
public:
  static vtkGarmentCodeReader* New();
  vtkTypeMacro(vtkGarmentCodeReader, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether a file looks like a pattern of GarmentCode: JSON that names panels in its first
   * megabyte.
   */
  static int CanReadFile(const char* name);

  ///@{
  /**
   * How the last run ended: the fixed name of a refusal ("InvalidPattern"), "Ok", or "NotRun" where
   * there was none yet; and what it said, empty after success.
   */
  const char* GetStatusName() const { return this->StatusName; }
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }
  ///@}

protected:
  vtkGarmentCodeReader();
  ~vtkGarmentCodeReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGarmentCodeReader(const vtkGarmentCodeReader&) = delete;
  void operator=(const vtkGarmentCodeReader&) = delete;

  char* FileName = nullptr;
  const char* StatusName = "NotRun";
  std::string ErrorMessage;
};

#endif
