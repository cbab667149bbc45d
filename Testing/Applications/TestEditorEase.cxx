// SPDX-License-Identifier: BSD-3-Clause
// A seam that is eased in one of its pieces by the window's table of curves.
#include "EditorSession.h"
#include "PolyDataOutput.h"
#include "ReadCurves.h"

#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkWireWarpingFilter.h>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableWidget>

#include <array>

using namespace session;

namespace
{
constexpr int easeColumn = 5;
constexpr int pieceColumn = 6;

class EditorEase : public PatternEditor
{
protected:
  /// A seam from side to side, which makes two pieces.
  void drawSeam()
  {
    this->draw({ 401, 6, 12 }, true);
    this->push(Hand::MAKE_SEAM);
    this->rename("yoke");
    this->waitForPieces();
  }

  void typeTolerance(const std::string& percents)
  {
    QDoubleSpinBox* const field = this->window->panel()->tolerance();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QString::fromStdString(percents));
    QTest::keyClick(field, Qt::Key_Return);
    this->waitForPieces();
  }

  void ease(const QString& percents, const QString& piece)
  {
    this->fillCurveOptions("yoke", [&](QDialog*, QTableWidget* table, int row) {
      table->item(row, easeColumn)->setText(percents);
      table->item(row, pieceColumn)->setText(piece);
    });
  }

  /// Of the seam in the plane, in each piece.
  std::array<double, 2> lengths() const
  {
    return lengthsOf(this->window->flattening().result().wires);
  }

  static std::array<double, 2> lengthsOf(vtkPolyData* wires)
  {
    std::array<double, 2> lengths{};
    auto* const names =
      vtkStringArray::SafeDownCast(wires->GetCellData()->GetAbstractArray("CurveName"));
    vtkDataArray* const pieces = wires->GetCellData()->GetArray("PieceId");
    for (vtkIdType cell = 0; cell < wires->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> points;
      wires->GetLines()->GetCellAtId(cell, points);
      for (vtkIdType k = 1; names->GetValue(cell) == "yoke" && k < points->GetNumberOfIds(); ++k)
      {
        double from[3];
        double to[3];
        wires->GetPoint(points->GetId(k - 1), from);
        wires->GetPoint(points->GetId(k), to);
        lengths.at(static_cast<std::size_t>(pieces->GetTuple1(cell))) +=
          std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
      }
    }
    return lengths;
  }
};
}

TEST_F(EditorEase, ASeamIsLongerInThePieceThatIsChosenAndSoItIsExported)
{
  this->drawSeam();
  const std::array<double, 2> before = this->lengths();
  ASSERT_GT(before[0], 1.0);
  EXPECT_NEAR(before[0], before[1], 1e-6 * before[0]);
  this->typeTolerance("4");
  this->ease("+3%", "2");
  std::array<double, 2> after = this->lengths();
  EXPECT_NEAR(after[0] / before[0], 1.0, 1e-6);
  EXPECT_NEAR(after[1] / before[1], 1.03, 1e-6);

  const std::string path = this->file("eased.json");
  ASSERT_TRUE(this->window->savePattern(path)) << this->window->message().toStdString();
  EXPECT_NE(textOf(path).find("yoke"), std::string::npos);

  // The fields show it; in the other piece, and then in none.
  this->fillCurveOptions("yoke", [](QDialog*, QTableWidget* table, int row) {
    EXPECT_EQ(table->item(row, easeColumn)->text(), "+3 %");
    EXPECT_EQ(table->item(row, pieceColumn)->text(), "2");
    table->item(row, easeColumn)->setText("-2");
    table->item(row, pieceColumn)->setText("1");
  });
  after = this->lengths();
  EXPECT_NEAR(after[0] / before[0], 0.98, 1e-6);
  EXPECT_NEAR(after[1] / before[1], 1.0, 1e-6);
  this->ease("", "");
  this->typeTolerance("0");
  after = this->lengths();
  EXPECT_NEAR(after[0] / before[0], 1.0, 1e-6);
  EXPECT_NEAR(after[1] / before[1], 1.0, 1e-6);
}

TEST_F(EditorEase, AnEaseIsSavedWithItsCurveAndCanBeUndone)
{
  this->drawSeam();
  this->typeTolerance("4");
  this->ease("+3%", "2");
  const std::array<double, 2> eased = this->lengths();
  ASSERT_NEAR(eased[1] / eased[0], 1.03, 1e-6);
  const std::string path = this->file("eased_curves.vtp");
  ASSERT_TRUE(this->window->saveCurves(path)) << this->window->message().toStdString();

  QTest::keyClick(this->window.get(), Qt::Key_Z, Qt::ControlModifier);
  this->waitForPieces();
  EXPECT_NEAR(this->lengths()[1] / this->lengths()[0], 1.0, 1e-6);

  this->open();
  ASSERT_TRUE(this->window->openCurves(path)) << this->window->message().toStdString();
  this->waitForPieces();
  for (std::size_t piece : { 0, 1 })
  {
    EXPECT_NEAR(this->lengths().at(piece), eased.at(piece), 1e-9 * eased.at(piece)) << piece;
  }
  this->fillCurveOptions("yoke", [](QDialog*, QTableWidget* table, int row) {
    EXPECT_EQ(table->item(row, easeColumn)->text(), "+3 %");
    EXPECT_EQ(table->item(row, pieceColumn)->text(), "2");
  });

  // Any program that reads the file gets the same.
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(this->surface);
  filter->SetCurvesData(
    wirewarp::polyDataOf(wirewarp::readCurves(path, wirewarp::dataSetOf(this->surface)).curves));
  filter->Update();
  EXPECT_STREQ(filter->GetStatusName(), "Ok") << filter->GetStatusMessage();
  vtkPolyData* const wires = filter->GetOutput(1);
  const std::array<double, 2> others = lengthsOf(wires);
  for (std::size_t piece : { 0, 1 })
  {
    EXPECT_NEAR(others.at(piece), eased.at(piece), 1e-9 * eased.at(piece)) << piece;
  }
}

TEST_F(EditorEase, WhatCannotBeIsSaid)
{
  this->drawSeam();
  this->fillCurveOptions("yoke", [](QDialog* dialog, QTableWidget* table, int row) {
    const auto said = [&](const char* ease, const char* piece) {
      table->item(row, easeColumn)->setText(ease);
      table->item(row, pieceColumn)->setText(piece);
      dialog->accept();
      EXPECT_TRUE(dialog->isVisible());
      return dialog->findChild<QLabel*>("Defect")->text().toStdString();
    };
    EXPECT_EQ(said("a bit", "1"), "Ease of yoke: a bit is not a percentage, such as +3 %");
    EXPECT_EQ(said("3", "0"), "Piece of yoke: 0 is not the number of a piece, from 1");
    EXPECT_EQ(said("", "2"), "Piece of yoke: there is no ease for it");
    table->item(row, easeColumn)->setText("3");
    table->item(row, pieceColumn)->setText("2");
  });
  // Without a tolerance as large it is refused by name, and nothing else is drawn.
  EXPECT_TRUE(this->window->message().contains("yoke")) << this->window->message().toStdString();
  EXPECT_TRUE(this->window->flattening().isRefused());
  this->typeTolerance("3");
  EXPECT_FALSE(this->window->flattening().isRefused());
  EXPECT_NEAR(this->lengths()[1] / this->lengths()[0], 1.03, 1e-6);
}
