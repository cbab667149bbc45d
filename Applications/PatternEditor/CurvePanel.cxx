// SPDX-License-Identifier: BSD-3-Clause
#include "CurvePanel.h"

#include <vtkFeatureCurveRepresentation.h>

#include <vtkFeatureCurveAlgorithm.h>
#include <vtkFeatureCurveEditor.h>

#include <QFormLayout>
#include <QIcon>
#include <QPixmap>
#include <QVBoxLayout>

#include <array>

namespace editor
{
QColor colorOfType(int type)
{
  std::array<unsigned char, 3> color;
  vtkFeatureCurveRepresentation::GetTypeColor(type, color.data());
  return { color[0], color[1], color[2] };
}

namespace
{
constexpr double percent = 100.0;
constexpr int swatchSize = 12; // pixels

QIcon swatch(int type)
{
  QPixmap square(swatchSize, swatchSize);
  square.fill(colorOfType(type));
  return QIcon(square);
}

/// The types in their colors.
QLabel* makeLegend()
{
  QString words;
  for (int type = 0; type < 4; ++type)
  {
    words += QString("<span style='color:%1'>&#9632;</span>&nbsp;%2 ")
               .arg(colorOfType(type).name())
               .arg(vtkFeatureCurveRepresentation::GetTypeName(type));
  }
  auto* const legend = new QLabel(words);
  legend->setObjectName("legend");
  legend->setWordWrap(true);
  return legend;
}
}

CurvePanel::CurvePanel(vtkFeatureCurveEditor* curves)
  : Curves(curves)
  , List(new QListWidget(this))
  , Name(new QLineEdit(this))
  , Type(new QComboBox(this))
  , Straight(new QCheckBox("straight in the plane", this))
  , Mirrored(new QCheckBox("mirrored", this))
  , Tolerance(new QDoubleSpinBox(this))
  , Length(new QLabel(this))
{
  for (int type = 0; type < 4; ++type)
  {
    this->Type->addItem(swatch(type), vtkFeatureCurveRepresentation::GetTypeName(type));
  }
  this->Tolerance->setRange(0.0, 99.0);
  this->Tolerance->setDecimals(2);
  this->Tolerance->setSuffix(" %");
  this->Straight->setToolTip("Of a key: it becomes a straight line in the flat piece.");
  this->Mirrored->setToolTip("The curve lies on both sides of the mirror plane.");
  this->List->setToolTip("The curves with their lengths; click one to choose it.");
  this->List->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->Tolerance->setToolTip("How far the length may go from that on the surface; 0: not at all.");
  auto* const form = new QFormLayout;
  form->addRow("Name", this->Name);
  form->addRow("Type", this->Type);
  form->addRow(this->Straight);
  form->addRow(this->Mirrored);
  form->addRow("Tolerance", this->Tolerance);
  form->addRow("Length", this->Length);
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(this->List, 1);
  layout->addWidget(makeLegend());
  layout->addLayout(form);

  connect(this->List, &QListWidget::currentRowChanged, [this](int row) {
    if (!this->Showing && this->onChoose)
    {
      this->onChoose(row);
    }
  });
  connect(this->Name, &QLineEdit::editingFinished, [this] { this->takeName(); });
  connect(this->Type, QOverload<int>::of(&QComboBox::activated),
    [this](int type) { this->apply(this->Curves->SetCurveType(this->Chosen, type)); });
  connect(this->Straight, &QCheckBox::clicked,
    [this](bool on) { this->apply(this->Curves->SetCurveKeyShape(this->Chosen, on ? 1 : 0)); });
  connect(this->Mirrored, &QCheckBox::clicked, [this] {
    this->onMirror();
    this->showChosen(); // as it was, where the surface has no mirror plane
  });
  connect(this->Tolerance, &QDoubleSpinBox::editingFinished, [this] { this->takeTolerance(); });
  this->show(-1);
}

void CurvePanel::apply(bool done)
{
  if (!done)
  {
    const std::string why = this->Curves->GetMessage();
    this->showChosen();
    this->onRefusal(why);
  }
}

void CurvePanel::takeName()
{
  const std::string name = this->Name->text().toStdString();
  if (!this->Showing && this->Name->isModified() && name != this->Shown)
  {
    this->Name->setModified(false); // or the field would not show what has been made of it
    const bool done = this->Curves->SetCurveName(this->Chosen, name);
    this->Name->setModified(!done);
    this->apply(done);
  }
}

void CurvePanel::takeTolerance()
{
  const double percents = this->Tolerance->value();
  if (!this->Showing && percents != this->ShownPercents)
  {
    this->ShownPercents = percents;
    this->apply(this->Curves->SetCurveTolerance(this->Chosen, percents / percent));
  }
}

void CurvePanel::takeTyped()
{
  // Unless the curve has gone, and another one has its number.
  if (!this->Showing && this->Chosen >= 0 &&
    this->Curves->GetCurveName(this->Chosen) == this->Shown)
  {
    this->takeTolerance();
    this->takeName();
  }
  this->Name->setModified(false);
  this->ShownPercents = this->Tolerance->value();
}

void CurvePanel::setUnit(const QString& unit)
{
  this->Unit = unit;
  this->show(this->Chosen);
}

void CurvePanel::show(int chosen)
{
  if (chosen != this->Chosen)
  {
    this->takeTyped(); // it was meant for the other one
  }
  this->Showing = true;
  this->Chosen = chosen;
  const int count = this->Curves->GetNumberOfCurves();
  while (this->List->count() > count)
  {
    delete this->List->takeItem(this->List->count() - 1);
  }
  for (int curve = 0; curve < count; ++curve)
  {
    if (curve == this->List->count())
    {
      this->List->addItem("");
    }
    const int type = this->Curves->GetCurveType(curve);
    const QString length = QString::number(this->Curves->GetCurveLength(curve), 'g', 4);
    const QString words = QString::fromStdString(this->Curves->GetCurveName(curve)) + ": " +
      (this->Curves->GetNumberOfNodes(curve) == 1 ? "one node" : length + " " + this->Unit);
    QListWidgetItem* const item = this->List->item(curve);
    // What is as it was is not painted again, at each step of a drag.
    if (item->text() != words || item->data(Qt::UserRole) != type)
    {
      item->setText(words);
      item->setData(Qt::UserRole, type);
      item->setIcon(swatch(type));
    }
  }
  this->List->setCurrentRow(chosen);
  this->Showing = false;
  this->showChosen();
}

void CurvePanel::showChosen()
{
  this->Showing = true;
  const int curve = this->Chosen;
  for (QWidget* field : std::initializer_list<QWidget*>{
         this->Name, this->Type, this->Straight, this->Mirrored, this->Tolerance })
  {
    field->setEnabled(curve >= 0);
  }
  if (!this->Name->hasFocus() || !this->Name->isModified())
  {
    this->Shown = this->Curves->GetCurveName(curve);
    this->Name->setText(QString::fromStdString(this->Shown));
  }
  this->Type->setCurrentIndex(this->Curves->GetCurveType(curve));
  this->Straight->setChecked(this->Curves->GetCurveKeyShape(curve) != 0);
  this->Straight->setEnabled(
    curve >= 0 && this->Curves->GetCurveType(curve) == vtkFeatureCurveAlgorithm::KEY);
  this->Mirrored->setChecked(this->Curves->GetCurveMirrored(curve));
  if (this->Tolerance->value() == this->ShownPercents) // nothing else is being typed
  {
    this->Tolerance->setValue(percent * this->Curves->GetCurveTolerance(curve));
    this->ShownPercents = this->Tolerance->value();
  }
  this->Length->setText(curve < 0
      ? ""
      : QString("%1 %2").arg(this->Curves->GetCurveLength(curve), 0, 'g', 6).arg(this->Unit));
  this->Showing = false;
}
}
