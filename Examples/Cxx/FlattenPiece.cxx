// SPDX-License-Identifier: BSD-3-Clause
// The shortest useful pipeline: a surface and its feature curves in, the flat piece out.
#include <vtkNew.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkWireWarpingFilter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: FlattenPiece SURFACE.vtp CURVES.vtp FLAT.vtp\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkXMLPolyDataReader> surface;
  surface->SetFileName(argv[1]);
  vtkNew<vtkXMLPolyDataReader> curves;
  curves->SetFileName(argv[2]);

  vtkNew<vtkWireWarpingFilter> flattening;
  flattening->SetInputConnection(surface->GetOutputPort());
  flattening->SetCurvesConnection(curves->GetOutputPort());
  flattening->Update();
  if (flattening->IsRefused())
  {
    return EXIT_FAILURE; // the filter or a reader has said why
  }

  // What the filter measured is a table with one row per piece.
  std::cout << "largest length error of a wire edge: "
            << flattening->GetPieces()->GetValueByName(0, "MaxEdgeLengthError").ToDouble() << '\n';

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary();
  writer->SetInputConnection(flattening->GetOutputPort());
  writer->SetFileName(argv[3]);
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
