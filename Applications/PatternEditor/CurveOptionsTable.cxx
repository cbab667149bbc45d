// SPDX-License-Identifier: BSD-3-Clause
#include "CurveOptionsTable.h"

#include <vtkPatternWriter.h>
#include <vtkStringArray.h>

#include <QHeaderView>
#include <QLocale>
#include <QStringList>

#include <cmath>

namespace editor
{
namespace
{
QStringList wordsOf(const QString& text)
{
  const QString simple = text.simplified();
  return simple.isEmpty() ? QStringList() : simple.split(' ');
}

QString textOf(double millimetres)
{
  return QLocale::c().toString(millimetres, 'g', 10);
}

/// Less than 0 for what is no length.
double lengthOf(const QString& word)
{
  bool isNumber = false;
  const double length = QLocale::c().toDouble(word, &isNumber);
  return isNumber && std::isfinite(length) ? length : -1.0;
}
}

//------------------------------------------------------------------------------
CurveOptionsTable::CurveOptionsTable(
  const vtkPatternWriter* writer, std::set<std::string> curves, QWidget* parent)
  : QTableWidget(parent)
{
  const vtkSmartPointer<vtkStringArray> known = writer->GetCurvesWithOptions();
  for (vtkIdType k = 0; k < known->GetNumberOfValues(); ++k)
  {
    curves.insert(known->GetValue(k));
  }
  this->setColumnCount(Options);
  this->setHorizontalHeaderLabels(
    { "Allowance", "Notches at", "Double", "Smooth within", "Dart tip" });
  this->setToolTip("Millimetres, for one curve; empty: as for all. Notches at so many millimetres "
                   "from the start of the curve, separated by spaces.");
  this->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  for (const std::string& name : curves)
  {
    const int row = this->rowCount();
    this->insertRow(row);
    this->setVerticalHeaderItem(row, new QTableWidgetItem(QString::fromStdString(name)));
    const auto set = [&](Option option, const QString& text) {
      this->setItem(row, option, new QTableWidgetItem(text));
    };
    const auto setLength = [&](Option option, bool has, double length) {
      set(option, has ? textOf(length) : QString());
    };
    setLength(Allowance, writer->HasCurveAllowance(name), writer->GetCurveAllowance(name));
    QStringList notches;
    for (int k = 0; k < writer->GetNumberOfCurveNotches(name); ++k)
    {
      notches += textOf(writer->GetCurveNotch(name, k));
    }
    set(NotchesAt, notches.join(' '));
    set(DoubleNotches, {});
    QTableWidgetItem* const twice = this->item(row, DoubleNotches);
    twice->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    twice->setCheckState(writer->HasDoubleNotches(name) ? Qt::Checked : Qt::Unchecked);
    setLength(
      FairTolerance, writer->HasCurveFairTolerance(name), writer->GetCurveFairTolerance(name));
    setLength(DartTip, writer->HasCurveDartTip(name), writer->GetCurveDartTip(name));
  }
}

//------------------------------------------------------------------------------
std::string CurveOptionsTable::curve(int row) const
{
  return this->verticalHeaderItem(row)->text().toStdString();
}

//------------------------------------------------------------------------------
QString CurveOptionsTable::text(int row, Option option) const
{
  return this->item(row, option)->text().trimmed();
}

//------------------------------------------------------------------------------
QString CurveOptionsTable::defect() const
{
  for (int row = 0; row < this->rowCount(); ++row)
  {
    for (const Option option : { Allowance, NotchesAt, FairTolerance, DartTip })
    {
      const QStringList words = wordsOf(this->text(row, option));
      const bool isOne = option == NotchesAt || words.size() < 2;
      for (const QString& word : words)
      {
        if (!isOne || lengthOf(word) < 0.0)
        {
          return QString("%1 of %2: %3 is no length in millimetres")
            .arg(this->horizontalHeaderItem(option)->text(), this->verticalHeaderItem(row)->text(),
              this->text(row, option));
        }
      }
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void CurveOptionsTable::take(vtkPatternWriter* writer) const
{
  writer->RemoveAllCurveAllowances();
  writer->RemoveAllCurveNotches();
  writer->RemoveAllDoubleNotches();
  writer->RemoveAllCurveFairTolerances();
  writer->RemoveAllCurveDartTips();
  for (int row = 0; row < this->rowCount(); ++row)
  {
    const std::string name = this->curve(row);
    for (const QString& word : wordsOf(this->text(row, Allowance)))
    {
      writer->SetCurveAllowance(name, lengthOf(word));
    }
    for (const QString& word : wordsOf(this->text(row, NotchesAt)))
    {
      writer->AddCurveNotch(name, lengthOf(word));
    }
    if (this->item(row, DoubleNotches)->checkState() == Qt::Checked)
    {
      writer->AddDoubleNotches(name);
    }
    for (const QString& word : wordsOf(this->text(row, FairTolerance)))
    {
      writer->SetCurveFairTolerance(name, lengthOf(word));
    }
    for (const QString& word : wordsOf(this->text(row, DartTip)))
    {
      writer->SetCurveDartTip(name, lengthOf(word));
    }
  }
}
}
