// SPDX-License-Identifier: BSD-3-Clause
#include "PatternDialog.h"

#include <vtkPatternWriter.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

#include <string>
#include <utility>

namespace editor
{
//------------------------------------------------------------------------------
PatternDialog::PatternDialog(vtkPatternWriter* writer, const PieceEases& eases,
  const std::set<std::string>& curves, QWidget* parent)
  : QDialog(parent)
  , Writer(writer)
  , Form(new QFormLayout)
  , OfCurves(new CurveOptionsTable(writer, eases, curves))
  , Defect(new QLabel)
{
  this->setWindowTitle("Pattern options");
  this->addText("PatternSize", "Size", "Printed on each piece, such as M.",
    writer->GetPatternSize(), [writer](const std::string& text) { writer->SetPatternSize(text); });
  auto* const quantity = new QSpinBox;
  quantity->setRange(1, 1000000);
  quantity->setValue(writer->GetQuantity());
  this->addRow("Quantity", "Quantity", "How many of each piece are cut.", quantity);
  this->Take.emplace_back([writer, quantity] { writer->SetQuantity(quantity->value()); });

  this->addLength(
    "Allowance", "Seam allowance", "Between the sew line and the cut line.", writer->GetAllowance(),
    1e3, [writer](double mm) { writer->SetAllowance(mm); }, "10 mm, sheets 0");
  this->addLength(
    "NotchSpacing", "Notches every",
    "Along seams and darts, measured on the surface. 0: at the mouths of darts alone.",
    writer->GetNotchSpacing(), 1e5, [writer](double mm) { writer->SetNotchSpacing(mm); },
    "a sixth of the largest piece");
  this->addChoice("NotchCorners", "Notches at corners",
    "On the cut line, where the sew lines, drawn on, meet it.", writer->GetNotchCorners(),
    [writer](bool on) { writer->SetNotchCorners(on); });
  this->addChoice("NotchCurveEnds", "Notches at ends of curves",
    "Where curves end on the border, and opposite on what is sewn to it.",
    writer->GetNotchCurveEnds(), [writer](bool on) { writer->SetNotchCurveEnds(on); });
  this->addChoice("JoinMarks", "Marks of joins",
    "The same letters along both sides of what is sewn together.", writer->GetJoinMarks(),
    [writer](bool on) { writer->SetJoinMarks(on); });
  this->addLength("FairTolerance", "Smooth outlines within",
    "Borders and curves as splines of the same lengths, at most this far from the points of the "
    "mesh. 0: as the mesh has them.",
    writer->GetFairTolerance(), 100.0, [writer](double mm) { writer->SetFairTolerance(mm); });
  this->addChoice("Symmetrize", "Symmetric pieces",
    "Each piece that is symmetric to 0.5 mm, with its curves, as exactly its own mirror image.",
    writer->GetSymmetrize(), [writer](bool on) { writer->SetSymmetrize(on); });
  this->addLength("DartTip", "Dart tips drawn back", "Of folded darts, their legs with them.",
    writer->GetDartTip(), 1e3, [writer](double mm) { writer->SetDartTip(mm); });
  this->addChoice("CutDartsOut", "Cut darts out",
    "Along their seam allowance, where they are not to be folded.", writer->GetCutDartsOut(),
    [writer](bool on) { writer->SetCutDartsOut(on); });
  this->addChoice("CutOnFold", "Halves to cut on the fold", "Of each symmetric piece.",
    writer->GetCutOnFold(), [writer](bool on) { writer->SetCutOnFold(on); });
  this->addChoice("CutPairs", "One of each mirrored pair",
    "Of two pieces that are mirror images the first alone, to be cut in pairs.",
    writer->GetCutPairs(), [writer](bool on) { writer->SetCutPairs(on); });
  this->addLength("FabricWidth", "Lay on cloth of width",
    "All copies on cloth of this width, as short as is found, in place of the pattern; SVG and "
    "HPGL. 0: the pattern.",
    writer->GetFabricWidth(), 1e5, [writer](double mm) { writer->SetFabricWidth(mm); });
  this->addChoice("FabricNap", "The cloth has a nap", "No piece is turned by half a turn.",
    writer->GetFabricNap(), [writer](bool on) { writer->SetFabricNap(on); });
  this->addPaper();
  this->addChoice("WalkTable", "Table of seams in the PDF",
    "Both sides of each seam and dart, from notch to notch.", writer->GetWalkTable(),
    [writer](bool on) { writer->SetWalkTable(on); });
  this->addChoice("LaserColors", "Laser colours in the SVG", "Thin lines, a colour for each role.",
    writer->GetLaserColors(), [writer](bool on) { writer->SetLaserColors(on); });

  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QObject::connect(buttons, &QDialogButtonBox::accepted, this, &PatternDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, this, &PatternDialog::reject);
  auto* const layout = new QVBoxLayout(this);
  layout->addLayout(this->Form);
  this->OfCurves->setObjectName("CurveOptions");
  layout->addWidget(this->OfCurves);
  this->Defect->setObjectName("Defect");
  this->Defect->setWordWrap(true);
  this->Defect->hide();
  layout->addWidget(this->Defect);
  layout->addWidget(buttons);
}

//------------------------------------------------------------------------------
void PatternDialog::accept()
{
  const QString defect = this->OfCurves->defect();
  if (!defect.isEmpty())
  {
    this->Defect->setText(defect);
    this->Defect->show();
    return;
  }
  this->OfCurves->take(this->Writer);
  for (const std::function<void()>& take : this->Take)
  {
    take();
  }
  this->QDialog::accept();
}

//------------------------------------------------------------------------------
void PatternDialog::addRow(const char* property, const char* words, const char* tip, QWidget* field)
{
  field->setObjectName(property);
  field->setToolTip(tip);
  this->Form->addRow(words, field);
}

//------------------------------------------------------------------------------
void PatternDialog::addLength(const char* property, const char* words, const char* tip,
  double value, double most, std::function<void(double)> take, const char* byPieces)
{
  auto* const field = new QDoubleSpinBox;
  field->setRange(byPieces ? -1.0 : 0.0, most);
  field->setSpecialValueText(byPieces ? byPieces : "");
  field->setDecimals(2);
  field->setSuffix(" mm");
  field->setValue(value);
  this->addRow(property, words, tip, field);
  this->Take.emplace_back([field, take = std::move(take)] { take(field->value()); });
}

//------------------------------------------------------------------------------
void PatternDialog::addChoice(const char* property, const char* words, const char* tip, bool value,
  std::function<void(bool)> take)
{
  auto* const field = new QCheckBox;
  field->setChecked(value);
  this->addRow(property, words, tip, field);
  this->Take.emplace_back([field, take = std::move(take)] { take(field->isChecked()); });
}

//------------------------------------------------------------------------------
void PatternDialog::addText(const char* property, const char* words, const char* tip,
  const std::string& value, std::function<void(const std::string&)> take)
{
  auto* const field = new QLineEdit(QString::fromStdString(value));
  this->addRow(property, words, tip, field);
  this->Take.emplace_back(
    [field, take = std::move(take)] { take(field->text().trimmed().toStdString()); });
}

//------------------------------------------------------------------------------
void PatternDialog::addPaper()
{
  auto* const field = new QComboBox;
  for (const auto& [name, paper] : { std::pair("A4", vtkPatternWriter::A4),
         std::pair("Letter", vtkPatternWriter::LETTER), std::pair("A3", vtkPatternWriter::A3),
         std::pair("A0", vtkPatternWriter::A0), std::pair("one sheet", vtkPatternWriter::SHEET) })
  {
    field->addItem(name, static_cast<int>(paper));
  }
  field->setCurrentIndex(field->findData(this->Writer->GetPaper()));
  this->addRow("Paper", "Paper of the PDF", "Pages to be joined, or one sheet for all.", field);
  this->Take.emplace_back([this, field] { this->Writer->SetPaper(field->currentData().toInt()); });
}
}
