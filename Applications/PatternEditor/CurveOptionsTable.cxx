// SPDX-License-Identifier: BSD-3-Clause
#include "CurveOptionsTable.h"

#include <vtkPatternWriter.h>
#include <vtkStringArray.h>

#include <QHeaderView>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace editor
{
namespace
{
constexpr double inPercent = 100.0;
constexpr int mostWidth = 900; ///< pixels, before it is scrolled

QStringList wordsOf(const QString& text)
{
  const QString simple = text.simplified();
  return simple.isEmpty() ? QStringList() : simple.split(' ');
}

QString textOf(double millimetres)
{
  return QLocale::c().toString(millimetres, 'g', 10);
}

/// Of a percentage, with its sign or without.
std::optional<double> fractionOf(QString text)
{
  text.remove('%');
  text = text.trimmed();
  bool isNumber = false;
  const double number = QLocale::c().toDouble(text.startsWith('+') ? text.mid(1) : text, &isNumber);
  return isNumber && std::isfinite(number) ? std::make_optional(number / inPercent) : std::nullopt;
}

/// Less than 0 for what is no length.
double lengthOf(const QString& word)
{
  bool isNumber = false;
  const double length = QLocale::c().toDouble(word, &isNumber);
  return isNumber && std::isfinite(length) ? length : -1.0;
}
}

CurveOptionsTable::CurveOptionsTable(const vtkPatternWriter* writer, const PieceEases& eases,
  std::set<std::string> curves, QWidget* parent)
  : QTableWidget(parent)
{
  const vtkSmartPointer<vtkStringArray> known = writer->GetCurvesWithOptions();
  for (vtkIdType k = 0; k < known->GetNumberOfValues(); ++k)
  {
    curves.insert(known->GetValue(k));
  }
  this->setColumnCount(Options);
  this->setHorizontalHeaderLabels(
    { "Allowance", "Notches at", "Double", "Smooth within", "Dart tip", "Ease", "in piece" });
  this->setToolTip(
    "Millimetres, for one curve; empty: as for all. Notches at these distances in millimetres "
    "from the start of the curve, separated by spaces. An ease, such as +3 %, makes "
    "the curve longer in one piece alone: give its number where it is in two, and the "
    "curve a tolerance as large.");
  this->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
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
    const auto eased = eases.find(name);
    const PieceEase ease = eased == eases.end() ? PieceEase() : eased->second;
    set(Ease,
      ease.fraction == 0.0
        ? QString()
        : (ease.fraction > 0.0 ? "+" : "") + textOf(inPercent * ease.fraction) + " %");
    set(InPiece, ease.piece < 0 ? QString() : QString::number(ease.piece + 1));
    for (const Option option : { Ease, InPiece })
    {
      this->item(row, option)
        ->setFlags(eased == eases.end() ? Qt::NoItemFlags : this->item(row, option)->flags());
    }
  }
  this->resizeColumnsToContents();
  const int width = this->verticalHeader()->sizeHint().width() +
    this->horizontalHeader()->length() + 2 * this->frameWidth();
  this->setMinimumWidth(std::min(width, mostWidth));
}

std::string CurveOptionsTable::curve(int row) const
{
  return this->verticalHeaderItem(row)->text().toStdString();
}

QString CurveOptionsTable::text(int row, Option option) const
{
  return this->item(row, option)->text().trimmed();
}

QString CurveOptionsTable::defect() const
{
  QString defect;
  for (int row = 0; row < this->rowCount() && defect.isEmpty(); ++row)
  {
    defect = this->defectOfLengths(row);
    defect = defect.isEmpty() ? this->defectOfEase(row) : defect;
  }
  return defect;
}

QString CurveOptionsTable::defectOfLengths(int row) const
{
  for (const Option option : { Allowance, NotchesAt, FairTolerance, DartTip })
  {
    const QStringList words = wordsOf(this->text(row, option));
    const bool isOne = option == NotchesAt || words.size() < 2;
    for (const QString& word : words)
    {
      if (!isOne || lengthOf(word) < 0.0)
      {
        return QString("%1 of %2: %3 is not a length in millimetres")
          .arg(this->horizontalHeaderItem(option)->text(), this->verticalHeaderItem(row)->text(),
            this->text(row, option));
      }
    }
  }
  return {};
}

QString CurveOptionsTable::defectOfEase(int row) const
{
  const QString of = " of " + this->verticalHeaderItem(row)->text() + ": ";
  const QString ease = this->text(row, Ease);
  const QString piece = this->text(row, InPiece);
  const std::optional<double> fraction = fractionOf(ease);
  if (!ease.isEmpty() && !(fraction && std::abs(*fraction) < 1.0))
  {
    return "Ease" + of + ease + " is not a percentage, such as +3 %";
  }
  bool isNumber = true;
  if (!piece.isEmpty() && (piece.toInt(&isNumber) < 1 || !isNumber))
  {
    return "Piece" + of + piece + " is not the number of a piece, from 1";
  }
  return ease.isEmpty() && !piece.isEmpty() ? "Piece" + of + "there is no ease for it" : QString();
}

PieceEases CurveOptionsTable::eases() const
{
  PieceEases eases;
  for (int row = 0; row < this->rowCount(); ++row)
  {
    const std::optional<double> fraction = fractionOf(this->text(row, Ease));
    if (fraction && *fraction != 0.0)
    {
      const QString piece = this->text(row, InPiece);
      eases[this->curve(row)] = { *fraction, piece.isEmpty() ? -1 : piece.toInt() - 1 };
    }
  }
  return eases;
}

void CurveOptionsTable::take(vtkPatternWriter* writer) const
{
  writer->RemoveAllCurveAllowances();
  writer->RemoveAllCurveNotches();
  writer->RemoveAllDoubleNotches();
  writer->RemoveAllCurveFairTolerances();
  writer->RemoveAllCurveDartTips();
  using Setter = void (vtkPatternWriter::*)(const std::string&, double);
  constexpr std::array<std::pair<Option, Setter>, 4> setters{
    { { Allowance, &vtkPatternWriter::SetCurveAllowance },
      { NotchesAt, &vtkPatternWriter::AddCurveNotch },
      { FairTolerance, &vtkPatternWriter::SetCurveFairTolerance },
      { DartTip, &vtkPatternWriter::SetCurveDartTip } }
  };
  for (int row = 0; row < this->rowCount(); ++row)
  {
    const std::string name = this->curve(row);
    if (this->item(row, DoubleNotches)->checkState() == Qt::Checked)
    {
      writer->AddDoubleNotches(name);
    }
    for (const auto& [option, set] : setters)
    {
      for (const QString& word : wordsOf(this->text(row, option)))
      {
        (writer->*set)(name, lengthOf(word));
      }
    }
  }
}
}
