// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkObject.h>

#include <string>
#include <vector>

namespace wirewarp
{
/// Takes the errors and warnings of all VTK objects, of all threads, while it lives, instead of
/// VTK's own window, which would print them with file, line and address.
class VtkMessages
{
public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  const std::vector<std::string>& errors() const { return this->Errors; }
  const std::vector<std::string>& warnings() const { return this->Warnings; }
  /// The first error without VTK's prefix; empty where there is none.
  std::string firstError() const { return this->Errors.empty() ? "" : this->Errors.front(); }

private:
  class Window;
  static void add(std::vector<std::string>& list, const char* text);

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  int Verbosity = 0;             ///< of VTK's log before
  VtkMessages* Before = nullptr; ///< what took them, and will again
};

/// The ErrorCode of a reader that failed for this reason, empty after success; reports the failure
/// as the reader's error.
unsigned long codeOf(const std::string& path, const std::string& failure, vtkObject* reader);
}
