// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveOptionsTable.h"

#include <QDialog>
#include <QFormLayout>
#include <QLabel>

#include <functional>
#include <set>
#include <string>
#include <vector>

class vtkPatternWriter;

namespace editor
{
/// What patterns show, as the properties of a writer say: allowance, notches, darts, folds, smooth
/// outlines, paper; for all curves, and in a table for one. The writer takes the fields when they
/// are accepted. Fields have the names of the properties, so that a program can find them.
class PatternDialog : public QDialog
{
public:
  /// \param curves names of what can be drawn
  PatternDialog(vtkPatternWriter* writer, const PieceEases& eases,
    const std::set<std::string>& curves, QWidget* parent);

  void accept() override;
  /// As the fields have them.
  PieceEases eases() const { return this->OfCurves->eases(); }

private:
  /// \param byPieces what is shown where the pieces determine the length; null: they do not
  void addLength(const char* property, const char* words, const char* tip, double value,
    double most, std::function<void(double)> take, const char* byPieces = nullptr);
  void addChoice(const char* property, const char* words, const char* tip, bool value,
    std::function<void(bool)> take);
  void addText(const char* property, const char* words, const char* tip, const std::string& value,
    std::function<void(const std::string&)> take);
  void addPaper();
  void addRow(const char* property, const char* words, const char* tip, QWidget* field);

  vtkPatternWriter* Writer;
  QFormLayout* Form;
  CurveOptionsTable* OfCurves;
  QLabel* Defect;
  std::vector<std::function<void()>> Take; ///< one a field
};
}
