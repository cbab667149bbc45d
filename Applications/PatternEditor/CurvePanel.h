// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QWidget>

#include <functional>
#include <string>

class vtkFeatureCurveEditor;

namespace editor
{
/// The list of curves, and what the chosen one is.
class CurvePanel : public QWidget
{
public:
  explicit CurvePanel(vtkFeatureCurveEditor* curves);

  /// Shows the curves as they are, with one of them chosen, or none.
  void show(int chosen);

  std::function<void(int)> onChoose;
  /// A change was refused, with the reason.
  std::function<void(const std::string&)> onRefusal;

  QLineEdit* name() { return this->Name; }
  QListWidget* list() { return this->List; }

private:
  void apply(bool done);
  void showChosen();

  vtkFeatureCurveEditor* Curves;
  int Chosen = -1;
  bool Showing = false; ///< values are set by show(), not by the user
  QListWidget* List;
  QLineEdit* Name;
  QComboBox* Type;
  QCheckBox* Straight;
  QCheckBox* Mirrored;
  QDoubleSpinBox* Tolerance;
  QLabel* Length;
};
}
