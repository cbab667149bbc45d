// SPDX-License-Identifier: BSD-3-Clause
// A seam that is eased in one of its pieces by the window's table of curves.
#include "EditorSession.h"

#include <vtkIdList.h>
#include <vtkMath.h>

#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableWidget>

#include <array>
#include <functional>

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
    this->push(Hand::NEW_CURVE);
    this->push(Hand::SECTION);
    for (const vtkIdType id : { 401, 6, 12 })
    {
      this->clickSeen(id);
    }
    this->click({ 5, 5 }, Qt::RightButton);
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

  /// Fills the row of the seam in the pattern options, which are accepted then.
  void ask(const std::function<void(QDialog*, QTableWidget*, int)>& fill)
  {
    QTimer::singleShot(300, [fill] {
      auto* const dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      auto* const table = dialog->findChild<QTableWidget*>("CurveOptions");
      ASSERT_NE(table, nullptr);
      int row = 0;
      while (row + 1 < table->rowCount() && table->verticalHeaderItem(row)->text() != "yoke")
      {
        ++row;
      }
      fill(dialog, table, row);
      dialog->accept();
    });
    QTest::keyClick(this->window.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QApplication::setActiveWindow(this->window.get()); // the dialog was it
    this->waitForPieces();
  }

  void ease(const QString& percents, const QString& piece)
  {
    this->ask([&](QDialog*, QTableWidget* table, int row) {
      table->item(row, easeColumn)->setText(percents);
      table->item(row, pieceColumn)->setText(piece);
    });
  }

  /// Of the seam in the plane, in each piece.
  std::array<double, 2> lengths() const
  {
    std::array<double, 2> lengths{};
    vtkPolyData* const wires = this->window->flattening().result().wires;
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

  const std::string path = testing::TempDir() + "eased.json";
  ASSERT_TRUE(this->window->savePattern(path)) << this->window->message().toStdString();
  std::ifstream file(path);
  const std::string text{ std::istreambuf_iterator<char>(file), {} };
  EXPECT_NE(text.find("yoke"), std::string::npos);
  std::remove(path.c_str());

  // The fields show it; in the other piece, and then in none.
  this->ask([](QDialog*, QTableWidget* table, int row) {
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

TEST_F(EditorEase, WhatCannotBeIsSaid)
{
  this->drawSeam();
  this->ask([](QDialog* dialog, QTableWidget* table, int row) {
    const auto said = [&](const char* ease, const char* piece) {
      table->item(row, easeColumn)->setText(ease);
      table->item(row, pieceColumn)->setText(piece);
      dialog->accept();
      EXPECT_TRUE(dialog->isVisible());
      return dialog->findChild<QLabel*>("Defect")->text().toStdString();
    };
    EXPECT_EQ(said("a bit", "1"), "Ease of yoke: a bit is no percentage, such as +3 %");
    EXPECT_EQ(said("3", "0"), "Piece of yoke: 0 is no number of a piece, from 1");
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
