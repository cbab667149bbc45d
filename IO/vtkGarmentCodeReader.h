// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGarmentCodeReader
 * @brief read a sewing pattern of GarmentCode: panels as flat pieces with seams
 *
 * The JSON of GarmentCode (M. Korosteleva, O. Sorkine-Hornung, ACM Transactions on Graphics 42(6),
 * 2023) holds panels with straight and curved edges, stitches between edges, and where each panel
 * is in space. Outputs are in centimeters: **0** the panels as flat pieces, **1** their borders as
 * wires, **2** the panels in space, with the arrays of vtkWireWarpingFilter, so that
 * vtkPatternWriter draws them.
 *
 * Curved edges become chords within 0.02 mm. Edges under one label that are sewn together are one
 * seam, or a dart where both sides meet in a point; other edges with a label are accessory curves
 * of that name. The field data of output 1 holds panels and stitches as JSON in centimetres
 * (`GarmentCode`): vtkPatternWriter writes them again, but for the parameters of the design.
 *
 * **Errors**: one vtkErrorMacro names panel, edge, and remedy; GetErrorMessage() and GetErrorCode()
 * repeat it, RequestData() returns 0 and the outputs are empty.
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
