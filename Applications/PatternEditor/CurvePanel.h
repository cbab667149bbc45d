// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCheckBox>
#include <QColor>
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
/// The color in which curves of a type are drawn.
QColor colorOfType(int type);

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
  /// The chosen curve is to get an image in the mirror, or to lose it.
  std::function<void()> onMirror;

  /// Of all lengths.
  void setUnit(const QString& unit);

  QLineEdit* name() { return this->Name; }
  QListWidget* list() { return this->List; }
  QCheckBox* straight() { return this->Straight; }
  QCheckBox* mirrored() { return this->Mirrored; }
  QDoubleSpinBox* tolerance() { return this->Tolerance; }
  QString length() const { return this->Length->text(); }

private:
  void apply(bool done);
  void showChosen();
  void takeName();
  void takeTolerance();
  /// What was typed before another curve was chosen, without Return.
  void takeTyped();

  vtkFeatureCurveEditor* Curves;
  int Chosen = -1;
  QString Unit;
  bool Showing = false; ///< values are set by show(), not by the user
  std::string Shown;    ///< the name, before it is typed over
  double ShownPercents = 0.0;
  QListWidget* List;
  QLineEdit* Name;
  QComboBox* Type;
  QCheckBox* Straight;
  QCheckBox* Mirrored;
  QDoubleSpinBox* Tolerance;
  QLabel* Length;
};
}
