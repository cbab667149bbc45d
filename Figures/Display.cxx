// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#ifdef FIGURES_X11
#include <X11/Xlib.h>
#endif

namespace figures
{
void requireDisplay()
{
#ifdef FIGURES_X11
  const vtkNew<vtkRenderWindow> window;
  if (!window->IsA("vtkXOpenGLRenderWindow"))
  {
    return;
  }
  if (Display* const display = XOpenDisplay(nullptr))
  {
    XCloseDisplay(display);
    return;
  }
  const char* const name = std::getenv("DISPLAY");
  throw std::runtime_error("a picture needs an X server, and " +
    (name && *name ? "none answers at DISPLAY=" + std::string(name) : "DISPLAY is not set") +
    "; start one, or put xvfb-run -a before the command");
#endif
}
}
