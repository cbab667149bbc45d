// SPDX-License-Identifier: BSD-3-Clause
// PatternEditor [SURFACE [CURVES]]: draw curves on a surface and see it lie flat.
#include "EditorWindow.h"

#include <QApplication>
#include <QSurfaceFormat>

#include <cstring>
#include <iostream>

int main(int argc, char* argv[])
{
  for (int k = 1; k < argc; ++k)
  {
    if (argv[k][0] == '-')
    {
      const bool help = std::strcmp(argv[k], "--help") == 0;
      (help ? std::cout : std::cerr)
        << "usage: PatternEditor [SURFACE [CURVES]]\n"
           "Draws curves on a surface (.vtp, .vtk, .obj, .ply, .stl, .off, .gltf, .glb) and shows\n"
           "it flat.\n"
           "CURVES: what it saved before, or any polylines on the surface (.vtp, .vtk,\n"
           ".obj, .csv, .dxf), or lists of vertex ids (.txt)\n";
      return help ? 0 : 1;
    }
  }
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLStereoWidget::defaultFormat());
  const editor::Application application(argc, argv);
  editor::EditorWindow window;
  window.show();
  QApplication::processEvents(); // then the views have the size that a surface is to fill
  // Curves that were recovered are not replaced.
  if (argc > 1 && window.openSurface(argv[1]) && argc > 2 && !window.isWindowModified())
  {
    window.openCurves(argv[2]);
  }
  return QApplication::exec();
}
