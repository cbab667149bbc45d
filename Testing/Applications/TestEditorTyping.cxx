// SPDX-License-Identifier: BSD-3-Clause
// What a user types, for files and for curves, and what becomes of it.
#include "EditorSession.h"

#include <vtkCamera.h>

#include <QDir>
#include <QMenu>
#include <QMessageBox>

#include <filesystem>

using namespace session;

namespace
{
class EditorTyping : public PatternEditor
{
protected:
  void SetUp() override
  {
    this->PatternEditor::SetUp();
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication::setQuitOnLastWindowClosed(false);
    this->draw({ 401, 6 });
  }
  void saveAs(const std::string& name, Qt::Key key = Qt::Key_S)
  {
    QApplication::setActiveWindow(this->window.get());
    this->choose(this->file(name));
    QTest::keyClick(this->window.get(), key, Qt::ControlModifier);
  }
  /// Answers the question that comes next; without a button by Return.
  void answer(QMessageBox::StandardButton button)
  {
    this->asked = false;
    auto* const timer = new QTimer(this->window.get());
    QObject::connect(timer, &QTimer::timeout, [this, timer, button] {
      if (auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
      {
        this->asked = true;
        timer->deleteLater();
        timer->stop();
        button == QMessageBox::NoButton ? QTest::keyClick(box, Qt::Key_Return)
                                        : QTest::mouseClick(box->button(button), Qt::LeftButton);
      }
    });
    timer->start(100);
  }
  bool exists(const std::string& name) { return std::filesystem::exists(this->file(name)); }

  bool asked = false;
};
}

TEST_F(EditorTyping, WhateverNameIsTypedTheCurvesCanBeOpenedAgain)
{
  double node[3];
  this->window->curves()->GetNode(0, 1, node);
  const std::pair<const char*, const char*> names[] = { { "plain", "plain.vtp" },
    { "mein gr\u00f6\u00dfter Schnitt.v2", "mein gr\u00f6\u00dfter Schnitt.v2.vtp" },
    { "other.obj", "other.obj.vtp" }, { "kept.vtp", "kept.vtp" }, { "UPPER.VTP", "UPPER.VTP" } };
  for (const auto& [typed, written] : names)
  {
    this->saveAs(typed);
    ASSERT_TRUE(this->exists(written)) << this->window->message().toStdString();
    EXPECT_EQ(typed == std::string(written), this->exists(typed)) << typed;
    ASSERT_TRUE(this->window->openCurves(this->file(written)))
      << this->window->message().toStdString();
    ASSERT_EQ(this->window->curves()->GetNumberOfCurves(), 1);
    ASSERT_EQ(this->window->curves()->GetNumberOfNodes(0), 2);
    double again[3];
    this->window->curves()->GetNode(0, 1, again);
    EXPECT_TRUE(std::equal(node, node + 3, again)) << typed;
  }
  this->saveAs("pattern.v2", Qt::Key_E);
  EXPECT_TRUE(this->exists("pattern.v2.pdf")) << this->window->message().toStdString();
  this->saveAs("pattern.svg", Qt::Key_E);
  EXPECT_TRUE(this->exists("pattern.svg")) << this->window->message().toStdString();
}

TEST_F(EditorTyping, AFileWhoseExtensionWasNotTypedIsNotReplacedUnasked)
{
  this->saveAs("curves");
  const std::string path = this->file("curves.vtp");
  const std::string first = textOf(path);
  ASSERT_FALSE(first.empty());
  this->draw({ 12, 6 });
  this->answer(QMessageBox::NoButton);
  this->saveAs("curves");
  EXPECT_TRUE(this->asked);
  EXPECT_EQ(textOf(path), first);
  this->answer(QMessageBox::Yes);
  this->saveAs("curves");
  EXPECT_TRUE(this->asked);
  EXPECT_NE(textOf(path), first);
}

TEST_F(EditorTyping, WhatIsTypedForACurveIsKeptWhenAnotherIsChosen)
{
  vtkFeatureCurveEditor* const curves = this->window->curves();
  const auto type = [this](QLineEdit* field, const char* words) {
    QTest::mouseClick(field, Qt::LeftButton);
    field->selectAll();
    QTest::keyClicks(field, words); // and no Return
  };
  QLineEdit* const name = this->window->panel()->name();
  QLineEdit* const tolerance = this->window->panel()->tolerance()->findChild<QLineEdit*>();
  this->draw({ 12, 68 });
  ASSERT_EQ(curves->GetNumberOfCurves(), 2);
  this->window->panel()->onChoose(0);
  type(name, "bust");
  this->click(this->node(1, 1));
  EXPECT_EQ(curves->GetCurveName(0), "bust");
  EXPECT_EQ(curves->GetCurveName(1), "curve 2");
  type(name, "neck");
  this->click({ 5, 5 }); // nothing is chosen
  EXPECT_EQ(curves->GetCurveName(1), "neck");
  EXPECT_EQ(name->text(), "");
  this->click(this->node(1, 1));
  type(tolerance, "5");
  this->moveTo(this->vertex(7));
  this->click({ 5, 5 });
  EXPECT_DOUBLE_EQ(curves->GetCurveTolerance(1), 0.05);
  EXPECT_EQ(curves->GetCurveTolerance(0), 0.0);
  // What was typed for a curve that goes is of no other.
  this->window->panel()->onChoose(0);
  type(name, "gone");
  this->push(Hand::REMOVE_CURVE);
  ASSERT_EQ(curves->GetNumberOfCurves(), 1);
  EXPECT_EQ(curves->GetCurveName(0), "neck");
  EXPECT_DOUBLE_EQ(curves->GetCurveTolerance(0), 0.05);
}

TEST_F(EditorTyping, DialogsForFilesStartBesideTheSurfaceAndThenWhereTheLastFileIs)
{
  std::vector<QString> folders;
  const auto look = [&](Qt::Key key, Qt::KeyboardModifiers also = Qt::NoModifier) {
    QApplication::setActiveWindow(this->window.get());
    onDialog<QFileDialog>(500, [&folders](QFileDialog* dialog) {
      folders.push_back(dialog->directory().canonicalPath());
      dialog->reject();
    });
    QTest::keyClick(this->window.get(), key, Qt::ControlModifier | also);
  };
  const QString data = QDir(FLATTENING_DATA).canonicalPath();
  const QString saved = QDir(QString::fromStdString(this->file(""))).canonicalPath();
  ASSERT_NE(QDir::current().canonicalPath(), data);
  for (const Qt::Key key : { Qt::Key_S, Qt::Key_E, Qt::Key_P })
  {
    look(key);
  }
  EXPECT_EQ(folders, std::vector<QString>(3, data));
  this->saveAs("curves");
  folders.clear();
  look(Qt::Key_O);
  look(Qt::Key_O, Qt::ShiftModifier);
  look(Qt::Key_E);
  EXPECT_EQ(folders, std::vector<QString>(3, saved));
  // That of a surface that is opened in another way, such as by the command line.
  ASSERT_TRUE(this->window->openSurface(shirt));
  folders.clear();
  look(Qt::Key_O);
  EXPECT_EQ(folders, std::vector<QString>(1, data));
}

TEST_F(EditorTyping, ADialogInTheMiddleOfADragEndsIt)
{
  vtkFeatureCurveEditor* const curves = this->window->curves();
  const auto state = [curves] {
    double node[3];
    curves->GetNode(0, 1, node);
    return std::vector<double>(node, node + 3);
  };
  const std::vector<double> first = state();
  const QPoint from = this->node(0, 1);
  this->moveTo(from);
  this->press(from);
  for (int k = 1; k <= 4; ++k)
  {
    this->moveTo(from + QPoint(-10 * k, 5 * k), Qt::LeftButton);
  }
  const std::vector<double> dragged = state();
  ASSERT_NE(dragged, first);
  this->saveAs("in the middle"); // the dialog gets the button's release
  EXPECT_TRUE(this->exists("in the middle.vtp")) << this->window->message().toStdString();
  QApplication::setActiveWindow(this->window.get());
  this->moveTo(this->vertex(12));
  this->moveTo(this->vertex(68));
  EXPECT_EQ(state(), dragged);
  this->push(Hand::MAKE_KEY);
  this->push(Hand::UNDO);
  EXPECT_EQ(state(), dragged);
  EXPECT_EQ(curves->GetCurveType(0), 0);
  this->push(Hand::UNDO);
  EXPECT_EQ(state(), first);

  // Nor does the camera turn on.
  vtkCamera* const camera = this->window->space()->GetActiveCamera();
  const QPoint ground(this->window->spaceWidget()->width() / 2, 6);
  this->moveTo(ground);
  this->press(ground);
  this->moveTo(ground + QPoint(20, 0), Qt::LeftButton);
  this->moveTo(ground + QPoint(30, 0), Qt::LeftButton);
  this->saveAs("in a turn");
  EXPECT_TRUE(this->exists("in a turn.vtp"));
  const std::vector<double> place(camera->GetPosition(), camera->GetPosition() + 3);
  this->moveTo(ground + QPoint(90, 0));
  this->moveTo(ground + QPoint(140, 9));
  EXPECT_EQ(std::vector<double>(camera->GetPosition(), camera->GetPosition() + 3), place);
}

TEST_F(EditorTyping, AMenuInTheMiddleOfADragEndsIt)
{
  vtkFeatureCurveEditor* const curves = this->window->curves();
  const QPoint from = this->node(0, 1);
  this->moveTo(from);
  this->press(from);
  this->moveTo(from + QPoint(-10, 5), Qt::LeftButton);
  this->moveTo(from + QPoint(-20, 10), Qt::LeftButton);
  double dragged[3];
  curves->GetNode(0, 1, dragged);
  QMenu* const menu = this->window->menuBar()->actions().front()->menu();
  menu->popup(this->window->mapToGlobal(QPoint(5, 20)));
  menu->close();
  this->moveTo(this->vertex(68));
  double after[3];
  curves->GetNode(0, 1, after);
  EXPECT_TRUE(std::equal(dragged, dragged + 3, after));
}

TEST_F(EditorTyping, CurvesThatAreNotSavedAreLostOnlyByTheButtonThatSaysSo)
{
  const std::string path = this->file("kept.vtp");
  this->answer(QMessageBox::Cancel);
  EXPECT_FALSE(this->window->close());
  EXPECT_TRUE(this->asked);
  // Return is Save; without a name nothing is saved, and the window stays.
  this->answer(QMessageBox::NoButton);
  onDialog<QFileDialog>(1200, [](QFileDialog* dialog) { dialog->reject(); });
  EXPECT_FALSE(this->window->close());
  EXPECT_TRUE(this->window->isVisible());
  this->answer(QMessageBox::NoButton);
  QTimer::singleShot(700, [this, path] { this->choose(path); });
  EXPECT_TRUE(this->window->close());
  EXPECT_TRUE(this->exists("kept.vtp"));
  // What is saved is not asked for, wherever the mouse has been since.
  this->window->show();
  this->push(Hand::NEW_CURVE);
  this->moveTo(this->vertex(12));
  this->push(Hand::FINISH);
  EXPECT_TRUE(this->window->close());

  this->window->show();
  this->click(this->node(0, 1));
  this->push(Hand::MAKE_KEY);
  this->answer(QMessageBox::Discard);
  EXPECT_TRUE(this->window->close());
  EXPECT_TRUE(this->asked);
}
