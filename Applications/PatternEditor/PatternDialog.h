// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveOptionsTable.h"
#include "Options/OptionValues.h"

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
/// What patterns show: the options of patterns but those for experts, for all curves, and in a
/// table for one. The writer takes the fields when they are accepted. Fields have the names of the
/// properties, so that a program can find them.
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
  void add(const flattening::Option& option);

  vtkPatternWriter* Writer;
  QFormLayout* Form;
  CurveOptionsTable* OfCurves;
  QLabel* Defect;
  flattening::OptionValues Values;
  std::vector<std::function<void()>> Take; ///< one a field
};
}
