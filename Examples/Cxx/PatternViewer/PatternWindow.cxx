// SPDX-License-Identifier: BSD-3-Clause
#include "PatternWindow.h"

#include "ClickStyle.h"
#include "CurvePicker.h"

#include <vtkCommand.h>

#include <cstdio>
#include <stdexcept>

namespace viewer
{
const char* const keyHelp = "click a curve: accessory, key, released\n"
                            "drag or wheel: turn, move, zoom; r: whole view\n"
                            "colours: 1 developability, 2 homogeneity, 3 aspect ratio, 4 area\n"
                            "save: p picture, s SVG, c curves\n"
                            "h: these keys; q: quit";

//------------------------------------------------------------------------------
PatternWindow::PatternWindow(PatternModel& model, const WindowOptions& options)
  : Model(model)
  , Options(options)
  , Picture(options.width, options.height, options.samples)
  , Message(keyHelp)
{
  vtkNew<ClickStyle> style;
  style->plane = this->Picture.plane();
  style->onClick = [this](int x, int y) { this->click(x, y); };
  style->onKey = [this](const std::string& key) { this->press(key); };
  this->Interactor->SetRenderWindow(this->Picture.window());
  this->Interactor->SetInteractorStyle(style);
  // Another size shares the window out anew.
  this->Interactor->AddObserver(vtkCommand::ConfigureEvent, this, &PatternWindow::draw);
}

//------------------------------------------------------------------------------
void PatternWindow::open()
{
  this->Picture.window()->SetWindowName(this->Options.title.c_str());
  this->Interactor->Initialize();
  this->draw();
}

//------------------------------------------------------------------------------
void PatternWindow::draw()
{
  figures::PatternScene scene;
  scene.piece = this->Model.result();
  scene.coloring = this->Coloring;
  scene.releasedInSpace = this->Model.releasedLines(false);
  scene.releasedInPlane = this->Model.releasedLines(true);
  scene.title = this->Options.title;
  scene.message = this->Message;
  scene.warning = this->Warning;
  this->Picture.show(scene);
}

//------------------------------------------------------------------------------
void PatternWindow::click(int x, int y)
{
  vtkRenderer* const renderer = this->Interactor->FindPokedRenderer(x, y);
  const bool inPlane = renderer == this->Picture.plane();
  if (!inPlane && renderer != this->Picture.space())
  {
    return;
  }
  const int curve = pickCurve(this->Model, renderer, inPlane, { x, y });
  if (curve < 0)
  {
    return;
  }
  const bool changed = this->Model.advance(curve);
  this->Warning = !this->Model.message().empty();
  this->Message = this->Model.message();
  if (changed)
  {
    this->Message = this->Model.curveName(curve) + " is " + nameOf(this->Model.role(curve)) +
      (this->Warning ? "; " + this->Message : "");
  }
  this->draw();
}

//------------------------------------------------------------------------------
void PatternWindow::press(const std::string& key)
{
  const std::size_t number = key.size() == 1 ? static_cast<std::size_t>(key[0] - '1') : 4;
  if (number < figures::colorings.size())
  {
    this->Coloring = figures::colorings[number];
  }
  else if (key == "r")
  {
    this->Picture.resetCameras();
  }
  else if (key == "h")
  {
    this->Message = keyHelp;
    this->Warning = false;
  }
  else if (key == "p" || key == "s" || key == "c")
  {
    this->save(key);
  }
  else
  {
    if (key == "q" || key == "e")
    {
      this->Interactor->TerminateApp();
    }
    return;
  }
  this->draw();
}

//------------------------------------------------------------------------------
void PatternWindow::save(const std::string& key)
{
  const std::string& prefix = this->Options.prefix;
  this->Warning = false;
  try
  {
    std::vector<std::string> files;
    if (key == "p")
    {
      files = { prefix + ".png" };
      this->Message.clear();
      this->draw();
      const std::string aside = prefix + ".part.png";
      this->Picture.write(aside);
      if (std::rename(aside.c_str(), files[0].c_str()) != 0)
      {
        throw std::runtime_error("cannot write " + files[0]);
      }
    }
    else if (key == "s")
    {
      files = { prefix + ".svg" };
      this->Model.writePattern(files[0], this->Options.unit);
    }
    else
    {
      files = this->Model.writeCurves(prefix);
    }
    this->Message = "saved";
    for (const std::string& file : files)
    {
      this->Message += " " + file;
    }
  }
  catch (const std::runtime_error& error)
  {
    this->Message = error.what();
    this->Warning = true;
  }
}
}
