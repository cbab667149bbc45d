// SPDX-License-Identifier: BSD-3-Clause
// Colours a surface from blue, developable, to red, where it must stretch or take a dart.
#include "Figure.h"
#include "Panels.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace
{
void show(vtkRenderWindow* window)
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(window);
  interactor->Start();
}
}

int main(int argc, char* argv[])
{
  const bool toFile = argc == 4 && std::string(argv[2]) == "--png";
  if (argc != 2 && !toFile)
  {
    std::cerr << "usage: DevelopabilityMap SURFACE.vtp [--png PICTURE.png]\n"
                 "Without --png a window opens.\n";
    return EXIT_FAILURE;
  }
  try
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(argv[1]);
    reader->Update();
    const figures::PolyData surface = reader->GetOutput();
    if (surface->GetNumberOfCells() == 0)
    {
      return EXIT_FAILURE; // the reader has said why
    }
    figures::Figure figure(800, 800, 4);
    const double largest =
      figures::drawDevelopability(figure.add(), { { surface, nullptr } }, figures::facing(surface));
    figure.addScale("angle defect E_dev, rad", { 0.0, std::max(largest, figures::developable) });
    std::cout << "largest angle defect: " << largest << " rad\n";
    if (toFile)
    {
      figure.write(argv[3]);
    }
    else
    {
      show(figure.render());
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "DevelopabilityMap: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
