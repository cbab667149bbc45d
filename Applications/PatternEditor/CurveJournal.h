// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>

#include <QLockFile>
#include <QString>

#include <memory>
#include <string>

namespace editor
{
/// The unsaved curves of a window in a file of the user's, so that a crash does not lose them. The
/// file is named by the surface's content, wherever that was read from, and locked while its window
/// lives: windows on one surface have files of their own.
class CurveJournal
{
public:
  CurveJournal() = default;
  ~CurveJournal() { this->close(); }
  CurveJournal(const CurveJournal&) = delete;
  CurveJournal& operator=(const CurveJournal&) = delete;

  /// Closes the file of the surface before.
  void open(vtkPolyData* surface);
  /// The curves that a window on this surface left which ended without closing; empty: none.
  std::string leftover() const;
  /// Replaces the curves in the file: it holds those before or these at any time. Throws
  /// std::runtime_error where it cannot be written.
  void write(vtkPolyData* curves) const;
  /// There is nothing unsaved.
  void clear() const;

private:
  void close();

  QString Path; ///< empty without a surface, or where no file can be had
  std::unique_ptr<QLockFile> Lock;
};
}
