// SPDX-License-Identifier: BSD-3-Clause
// Flattens a surface with its feature curves and draws the pieces beside it, colored by how their
// area changed, in a window or into a PNG file.
#include <vtkActor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkVariant.h>
#include <vtkVersionMacros.h>
#include <vtkWindowToImageFilter.h>
#include <vtkWireWarpingFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdlib>
#include <iostream>

namespace
{
vtkSmartPointer<vtkActor> addActor(
  vtkRenderer* renderer, vtkAlgorithmOutput* data, vtkLookupTable* colors)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(data);
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
  return actor;
}

/// Blue at 1, where the area is kept, to red at 0.5, where it has doubled or halved.
vtkSmartPointer<vtkLookupTable> homogeneityColors()
{
  auto colors = vtkSmartPointer<vtkLookupTable>::New();
  colors->SetTableRange(0.5, 1.0);
  colors->SetHueRange(0.0, 0.667);
  colors->Build();
  return colors;
}

/// Connector, boundary, accessory, key, dart, seam: -2 to 3.
vtkSmartPointer<vtkLookupTable> wireColors()
{
  auto colors = vtkSmartPointer<vtkLookupTable>::New();
  colors->SetNumberOfTableValues(6);
  colors->SetTableRange(-2.0, 3.0);
  colors->SetTableValue(0, 0.7, 0.7, 0.7);
  colors->SetTableValue(1, 0.0, 0.0, 0.0);
  colors->SetTableValue(2, 0.0, 0.6, 0.1);
  colors->SetTableValue(3, 0.85, 0.0, 0.0);
  colors->SetTableValue(4, 0.0, 0.2, 0.9);
  colors->SetTableValue(5, 0.6, 0.0, 0.75);
  return colors;
}

/// Without an X server VTK ends the program; since 9.4 it draws what nobody sees without one.
bool canDraw(bool offScreen)
{
#ifdef __linux__
  const char* const display = std::getenv("DISPLAY");
  const bool needsNone = offScreen && VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0);
  return needsNone || (display && *display);
#else
  return true;
#endif
}
}

int main(int argc, char* argv[])
{
  if (argc < 2 || argc > 4)
  {
    std::cerr << "usage: FlattenAndDraw SURFACE.vtp [CURVES.vtp [PICTURE.png]]\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkXMLPolyDataReader> surface;
  surface->SetFileName(argv[1]);
  vtkNew<vtkXMLPolyDataReader> curves;
  vtkNew<vtkWireWarpingFilter> flattening;
  flattening->SetInputConnection(surface->GetOutputPort());
  if (argc > 2)
  {
    curves->SetFileName(argv[2]);
    flattening->AddCurvesConnection(curves->GetOutputPort());
  }
  flattening->BesideSurfaceOn();
  flattening->Update();
  if (flattening->IsRefused())
  {
    std::cerr << flattening->GetStatusName() << ": " << flattening->GetStatusMessage() << "\n";
    return EXIT_FAILURE;
  }
  vtkTable* const pieces = flattening->GetPieces();
  for (vtkIdType p = 0; p < pieces->GetNumberOfRows(); ++p)
  {
    std::cout << "piece " << p + 1 << ": " << pieces->GetValueByName(p, "Status").ToString()
              << ", largest length error of an edge "
              << pieces->GetValueByName(p, "MaxEdgeLengthError").ToDouble() << ", area error "
              << pieces->GetValueByName(p, "AreaError").ToDouble() << "\n";
  }

  if (!canDraw(argc == 4))
  {
    std::cerr << "nothing is drawn: DISPLAY names no X server. Start this on a desktop, or with "
                 "xvfb-run and a name for the picture\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  const auto homogeneity = homogeneityColors();
  addActor(renderer, flattening->GetOutputPort(0), homogeneity);
  addActor(renderer, flattening->GetOutputPort(1), wireColors())->GetProperty()->SetLineWidth(3.0F);
  addActor(renderer, flattening->GetOutputPort(2), homogeneity)->GetProperty()->LightingOn();
  vtkNew<vtkScalarBarActor> legend;
  legend->SetLookupTable(homogeneity);
  legend->SetTitle("homogeneity");
  legend->SetMaximumWidthInPixels(80);
  legend->SetVerticalTitleSeparation(10); // clear of the uppermost number
  legend->GetTitleTextProperty()->SetColor(0.0, 0.0, 0.0);
  legend->GetLabelTextProperty()->SetColor(0.0, 0.0, 0.0);
  renderer->AddActor2D(legend);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  window->SetSize(1200, 800);
  if (argc < 4)
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetInteractorStyle(vtkNew<vtkInteractorStyleTrackballCamera>());
    interactor->SetRenderWindow(window);
    window->Render();
    interactor->Start();
    return EXIT_SUCCESS;
  }
  window->OffScreenRenderingOn();
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argv[3]);
  writer->Write();
  return writer->GetErrorCode() ? EXIT_FAILURE : EXIT_SUCCESS;
}
