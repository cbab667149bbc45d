// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PatternModel.h"

#include <vtkRenderWindowInteractor.h>

#include <string>

namespace viewer
{
struct WindowOptions
{
  int width = 1600;
  int height = 1000;
  int samples = 4;
  std::string title;
  std::string prefix; ///< of the files that keys save
  std::string unit = "cm";
};

/// What the keys do, for the window and for the command line.
extern const char* const keyHelp;

/// The model in a window: clicks change curves, keys colour and save.
class PatternWindow
{
public:
  PatternWindow(PatternModel& model, const WindowOptions& options);

  /// Shows the window; Start() of the interactor then gives it to the user.
  void open();
  vtkRenderWindowInteractor* interactor() { return this->Interactor; }
  figures::PatternPicture& picture() { return this->Picture; }
  figures::Coloring coloring() const { return this->Coloring; }
  /// What is said in the corner.
  const std::string& message() const { return this->Message; }

private:
  void click(int x, int y);
  void press(const std::string& key);
  void save(const std::string& key);
  void draw();

  PatternModel& Model;
  WindowOptions Options;
  figures::PatternPicture Picture;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  figures::Coloring Coloring = figures::Coloring::Homogeneity;
  std::string Message;
  bool Warning = false;
};
}
