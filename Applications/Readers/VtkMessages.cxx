// SPDX-License-Identifier: BSD-3-Clause
#include "VtkMessages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>

namespace wirewarp
{
namespace
{
/// "ERROR: In file, line 7\nvtkX (0x123): text\n\n" becomes "text".
std::string strip(const std::string& message)
{
  std::string text = message;
  const std::size_t address = text.find("(0x");
  const std::size_t colon = text.find("): ", address == std::string::npos ? 0 : address);
  if (address != std::string::npos && colon != std::string::npos)
  {
    text = text.substr(colon + 3);
  }
  else if (text.rfind("ERROR: In ", 0) == 0 || text.rfind("Generic Warning: In ", 0) == 0)
  {
    text = text.substr(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
  {
    text.pop_back();
  }
  // A refusal is one line.
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}
}

//------------------------------------------------------------------------------
class VtkMessages::Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow)

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Owner->add(this->Owner->Errors, text); }
  void DisplayWarningText(const char* text) override { this->note(text); }
  void DisplayGenericWarningText(const char* text) override { this->note(text); }

  VtkMessages* Owner = nullptr;

private:
  void note(const char* text) const { this->Owner->add(this->Owner->Warnings, text); }
};
vtkStandardNewMacro(VtkMessages::Window);

//------------------------------------------------------------------------------
VtkMessages::VtkMessages()
{
  this->Verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Window> window;
  window->Owner = this;
  vtkOutputWindow::SetInstance(window);
}

VtkMessages::~VtkMessages()
{
  vtkOutputWindow::SetInstance(nullptr);
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(this->Verbosity));
}

void VtkMessages::add(std::vector<std::string>& list, const char* text)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  const std::string line = strip(text ? text : "");
  if (!line.empty())
  {
    list.push_back(line);
  }
}
}
