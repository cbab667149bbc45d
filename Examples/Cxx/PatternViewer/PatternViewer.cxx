// SPDX-License-Identifier: BSD-3-Clause
// A surface and its flat pieces in a window: a click on a curve makes it accessory, key or
// released, and the pieces are flattened anew at once.
#include "Display.h"
#include "PatternWindow.h"

#include <vtkXMLPolyDataReader.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <stdexcept>

namespace
{
const char* const usage =
  "usage: PatternViewer SURFACE.vtp [CURVES.vtp [RELEASED.vtp]] [--save PREFIX] [--unit UNIT]\n"
  "  RELEASED.vtp  curves to choose from that are no wires yet\n"
  "  --save        what the files that keys save begin with (default: pattern)\n"
  "  --unit        of the surface, for the SVG: mm, cm, m, inch (default: cm)\n";

figures::PolyData read(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw std::runtime_error("cannot read " + path + " as .vtp");
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

std::string nameOf(const std::string& path)
{
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.rfind('.'));
}
}

int main(int argc, char* argv[])
{
  std::vector<figures::PolyData> inputs;
  viewer::WindowOptions options;
  options.prefix = "pattern";
  std::map<std::string, std::string*> flags{ { "--save", &options.prefix },
    { "--unit", &options.unit } };
  try
  {
    for (int k = 1; k < argc; ++k)
    {
      const std::string argument = argv[k];
      const auto flag = flags.find(argument);
      if (flag != flags.end() && k + 1 < argc)
      {
        *flag->second = argv[++k];
        continue;
      }
      if (flag != flags.end() || argument[0] == '-' || inputs.size() == 3)
      {
        std::cerr << usage << viewer::keyHelp << '\n';
        return argument == "--help" ? EXIT_SUCCESS : EXIT_FAILURE;
      }
      options.title = inputs.empty() ? nameOf(argument) : options.title;
      inputs.push_back(read(argument));
    }
    if (inputs.empty())
    {
      std::cerr << usage << viewer::keyHelp << '\n';
      return EXIT_FAILURE;
    }
    inputs.resize(3);
    figures::requireDisplay();
    viewer::PatternModel model(inputs[0], inputs[1], inputs[2]);
    model.flatten();
    viewer::PatternWindow window(model, options);
    window.open();
    window.interactor()->Start();
  }
  catch (const std::exception& error)
  {
    std::cerr << "PatternViewer: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
