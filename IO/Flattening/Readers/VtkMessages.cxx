// SPDX-License-Identifier: BSD-3-Clause
#include "VtkMessages.h"

#include <vtkErrorCode.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSetGet.h>

#include <algorithm>
#include <mutex>
#include <utility>

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

/// One for all, and never taken back: another thread may be about to use it.
class VtkMessages::Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow)

  static Window& theOne()
  {
    static Window* const window = [] {
      Window* const made = Window::New();
      vtkOutputWindow::SetInstance(made);
      return made;
    }();
    return *window;
  }

  /// \return the one before
  VtkMessages* setOwner(VtkMessages* owner)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    return std::exchange(this->Owner, owner);
  }

  void DisplayText(const char* text) override
  {
    if (!this->note(&VtkMessages::Errors, nullptr))
    {
      this->Superclass::DisplayText(text);
    }
  }
  void DisplayErrorText(const char* text) override
  {
    if (!this->note(&VtkMessages::Errors, text))
    {
      this->Superclass::DisplayErrorText(text);
    }
  }
  void DisplayWarningText(const char* text) override
  {
    if (!this->note(&VtkMessages::Warnings, text))
    {
      this->Superclass::DisplayWarningText(text);
    }
  }
  void DisplayGenericWarningText(const char* text) override
  {
    if (!this->note(&VtkMessages::Warnings, text))
    {
      this->Superclass::DisplayGenericWarningText(text);
    }
  }

private:
  /// \return whether somebody takes messages
  bool note(std::vector<std::string> VtkMessages::*list, const char* text)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Owner)
    {
      add(this->Owner->*list, text);
    }
    return this->Owner != nullptr;
  }

  std::mutex Guard; ///< VTK objects may speak from any thread
  VtkMessages* Owner = nullptr;
};
vtkStandardNewMacro(VtkMessages::Window);

VtkMessages::VtkMessages()
{
  this->Verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  this->Before = Window::theOne().setOwner(this);
}

VtkMessages::~VtkMessages()
{
  Window::theOne().setOwner(this->Before);
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(this->Verbosity));
}

void VtkMessages::add(std::vector<std::string>& list, const char* text)
{
  const std::string line = strip(text ? text : "");
  if (!line.empty())
  {
    list.push_back(line);
  }
}

unsigned long codeOf(const std::string& path, const std::string& failure, vtkObject* reader)
{
  if (failure.empty())
  {
    return vtkErrorCode::NoError;
  }
  vtkErrorWithObjectMacro(reader, << failure);
  return path.empty() ? vtkErrorCode::NoFileNameError : vtkErrorCode::FileFormatError;
}
}
