// SPDX-License-Identifier: BSD-3-Clause
// Proposals, files and patterns of PatternEditor.
#include "EditorSession.h"
#include "FaceSeams.h"

#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkPatternWriter.h>
#include <vtkStringArray.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>

#include <array>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace session;

TEST_F(PatternEditor, ProposalsAreTakenOneByOneOrAllAndUndone)
{
  ASSERT_TRUE(this->window->openSurface(FLATTENING_DATA "/quarter_sphere.vtp"));
  vtkFeatureCurveEditor* const curves = this->window->curves();
  editor::ProposalBox* const box = this->window->proposals();
  this->waitForPieces();
  const double before = this->measure("StrainP95");
  QTest::keyClick(this->window.get(), Qt::Key_F6);
  QApplication::setActiveWindow(this->window.get()); // the dialog was it
  ASSERT_GE(box->cuts().size(), 2U) << this->window->message().toStdString();
  EXPECT_TRUE(box->isVisible());
  EXPECT_TRUE(this->window->message().contains("mirrored across a plane"))
    << this->window->message().toStdString();
  const std::vector<editor::Proposal> proposed = box->cuts();
  EXPECT_EQ(curves->GetNumberOfCurves(), 0); // so far they are but shown
  this->picture("proposals");

  QTest::keyClick(this->window.get(), Qt::Key_F7);
  EXPECT_EQ(box->chosen(), 1U);
  QTest::keyClick(this->window.get(), Qt::Key_F9); // rejects the second
  EXPECT_EQ(box->cuts().size(), proposed.size() - 1);
  box->set({ proposed, {}, false, {} });
  QTest::keyClick(this->window.get(), Qt::Key_F8);
  ASSERT_EQ(curves->GetNumberOfCurves(), 1);
  EXPECT_EQ(curves->GetCurveName(0), proposed[0].name);
  EXPECT_EQ(curves->GetCurveType(0), proposed[0].type);
  EXPECT_NEAR(curves->GetCurveLength(0), proposed[0].length, 1e-3 * proposed[0].length);
  QTest::keyClick(this->window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(curves->GetNumberOfCurves(), 0);

  box->set({ proposed, {}, false, {} });
  QTest::keyClick(this->window.get(), Qt::Key_F8, Qt::ShiftModifier);
  EXPECT_EQ(curves->GetNumberOfCurves(), static_cast<int>(proposed.size()));
  EXPECT_FALSE(box->isVisible());
  this->waitForPieces();
  // The piece is strained as was foretold.
  EXPECT_LT(this->measure("StrainP95"), before);
  EXPECT_NEAR(
    this->measure("StrainP95"), proposed.back().strainAfter, 0.2 * proposed.back().strainAfter);
  this->picture("accepted");
  QTest::keyClick(this->window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(curves->GetNumberOfCurves(), 0);
}

// An array is offered where its numbers can be weights, and the one chosen is taken: of one with an
// infinite number the search says at which triangle.
TEST_F(PatternEditor, AnArrayOfTheSurfaceCanSayWhereDistortionMatters)
{
  figures::PolyData weighted =
    wirewarp::polyDataOf(wirewarp::readSurface(FLATTENING_DATA "/quarter_sphere.vtp").surface);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const auto& [name, number] :
    { std::pair<const char*, double>{ "Seen", 1.0 }, { "Signed", -1.0 }, { "Infinite", infinite } })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfValues(weighted->GetNumberOfCells());
    array->Fill(1.0);
    array->SetValue(5, number);
    weighted->GetCellData()->AddArray(array);
  }
  ASSERT_TRUE(this->window->openSurface(this->write(weighted, "weighted.vtp")))
    << this->window->message().toStdString();
  const auto ask = [&](const QString& name) {
    onDialog<QInputDialog>(300, [name](QInputDialog* dialog) {
      EXPECT_EQ(dialog->comboBoxItems(), QStringList({ "everywhere alike", "Seen", "Infinite" }));
      dialog->setTextValue(name);
      dialog->accept();
    });
    QTest::keyClick(this->window.get(), Qt::Key_F6);
    QApplication::setActiveWindow(this->window.get()); // the dialog was it
  };
  ask("Infinite");
  EXPECT_TRUE(this->window->proposals()->cuts().empty());
  EXPECT_TRUE(this->window->message().contains("weights of triangles 5"))
    << this->window->message().toStdString();
  ask("Seen"); // as where no array is chosen
  EXPECT_GE(this->window->proposals()->cuts().size(), 2U) << this->window->message().toStdString();
}

TEST_F(PatternEditor, ADamagedSurfaceIsHealedWhenItIsOpened)
{
  const std::string path = this->file("doubled.obj");
  std::ofstream(path) << "v 0 0 0\nv 9 0 0\nv 9 9 1\nv 0 9 0\nf 1 2 3\nf 1 3 4\nf 4 3 1\n";
  ASSERT_TRUE(this->window->openSurface(path)) << this->window->message().toStdString();
  EXPECT_EQ(this->window->message(), "1 triangle with the corners of another was taken out (2)");
  this->waitForPieces();
  EXPECT_GT(this->measure("AreaError"), -1.0);
}

TEST_F(PatternEditor, TheUnitIsKeptWithCurvesAndSurface)
{
  const std::string lines = this->file("unit_curves.vtp");
  const std::string saved = this->file("unit_surface.vtp");
  for (const char* const unit : { "m", "inch", "mm", "cm" })
  {
    this->window->unit()->setCurrentText(unit);
    vtkFeatureCurveEditor* const curves = this->window->curves();
    if (curves->GetNumberOfCurves() == 0)
    {
      ASSERT_TRUE(curves->SetCurves(tutorialLines(this->surface)));
    }
    ASSERT_TRUE(this->window->saveCurves(lines)) << this->window->message().toStdString();
    ASSERT_TRUE(this->window->saveSurface(saved)) << this->window->message().toStdString();

    this->open();
    ASSERT_EQ(this->window->unit()->currentText(), "cm");
    ASSERT_TRUE(this->window->openCurves(lines));
    EXPECT_EQ(this->window->unit()->currentText(), unit);
    EXPECT_EQ(this->window->message(), "");

    this->open();
    ASSERT_TRUE(this->window->openSurface(saved));
    EXPECT_EQ(this->window->unit()->currentText(), unit);
    ASSERT_TRUE(this->window->openCurves(lines));
    EXPECT_EQ(this->window->message(), "");
  }
  // A unit that was chosen is not changed by curves, but said to be another one.
  this->open();
  this->window->unit()->setCurrentText("inch");
  ASSERT_TRUE(this->window->openCurves(lines));
  EXPECT_EQ(this->window->unit()->currentText(), "inch");
  EXPECT_TRUE(this->window->message().contains("saved in cm, the surface is in inch"))
    << this->window->message().toStdString();
  // Where a file states none, the likely one is taken.
  ASSERT_TRUE(this->window->openSurface(FLATTENING_DATA "/quarter_sphere.vtp"));
  EXPECT_EQ(this->window->unit()->currentText(), "m");
  EXPECT_TRUE(this->window->message().contains("states no unit: m is taken, in which it is 2 m"))
    << this->window->message().toStdString();
}

TEST_F(PatternEditor, OptionsOfThePatternAreKeptWithTheCurves)
{
  const std::string lines = this->file("option_curves.vtp");
  ASSERT_TRUE(this->window->curves()->SetCurves(tutorialLines(this->surface)));
  vtkPatternWriter* pattern = this->window->pattern();
  pattern->SetAllowance(12.5);
  pattern->SetPatternSize("38=M");
  pattern->SetPaperToA0();
  pattern->JoinMarksOff();
  pattern->SetQuantity(2);
  ASSERT_TRUE(this->window->saveCurves(lines)) << this->window->message().toStdString();

  this->open();
  pattern = this->window->pattern();
  EXPECT_EQ(pattern->GetAllowance(), -1.0);
  ASSERT_TRUE(this->window->openCurves(lines));
  EXPECT_EQ(pattern->GetAllowance(), 12.5);
  EXPECT_STREQ(pattern->GetPatternSize(), "38=M");
  EXPECT_EQ(pattern->GetPaper(), static_cast<int>(vtkPatternWriter::A0));
  EXPECT_FALSE(pattern->GetJoinMarks());
  EXPECT_EQ(pattern->GetQuantity(), 2);
  EXPECT_EQ(pattern->GetDartTip(), 0.0);
}

TEST_F(PatternEditor, KeysShowTheSurfaceFromTheFrontTheSideAndAbove)
{
  vtkCamera* const camera = this->window->space()->GetActiveCamera();
  const auto lookedAlong = [&](Qt::Key key) {
    QTest::keyClick(this->window.get(), key);
    const double* const along = camera->GetDirectionOfProjection();
    return std::array<long, 3>{ std::lround(along[0]), std::lround(along[1]),
      std::lround(along[2]) };
  };
  // The shirt stands upright along y and faces z.
  using Way = std::array<long, 3>;
  EXPECT_EQ(lookedAlong(Qt::Key_F4), (Way{ -1, 0, 0 }));
  EXPECT_NEAR(camera->GetViewUp()[1], 1.0, 1e-9);
  EXPECT_EQ(lookedAlong(Qt::Key_F5), (Way{ 0, -1, 0 }));
  EXPECT_EQ(lookedAlong(Qt::Key_F2), (Way{ 0, 0, -1 }));
  EXPECT_NEAR(camera->GetViewUp()[1], 1.0, 1e-9);
}

TEST_F(PatternEditor, ASearchForProposalsCanBeStopped)
{
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [] {
    for (QWidget* widget : QApplication::topLevelWidgets())
    {
      if (auto* const dialog = qobject_cast<QProgressDialog*>(widget))
      {
        dialog->cancel();
      }
    }
  });
  timer.start(50);
  this->window->propose();
  EXPECT_TRUE(this->window->proposals()->cuts().empty());
  EXPECT_TRUE(this->window->message().contains("stopped")) << this->window->message().toStdString();
}

TEST_F(PatternEditor, PatternsAndPicturesAreWritten)
{
  this->drawTutorial();
  for (const char* extension : { ".pdf", ".svg", ".dxf", ".png" })
  {
    const std::string path = this->file(std::string("editor_pattern") + extension);
    const bool picture = std::string(extension) == ".png";
    EXPECT_TRUE(picture ? this->window->savePicture(path) : this->window->savePattern(path))
      << this->window->message().toStdString();
    EXPECT_GT(textOf(path).size(), 2000U) << extension;
    if (picture)
    {
      // Both views are in it, with all the colors of a surface.
      const QImage image(QString::fromStdString(path));
      for (QWidget* view :
        std::initializer_list<QWidget*>{ this->window->spaceWidget(), this->window->planeWidget() })
      {
        std::set<QRgb> colors;
        const QRect place(view->mapTo(this->window.get(), QPoint(0, 0)), view->size());
        for (int x = place.left(); x < place.right(); ++x)
        {
          colors.insert(image.pixel(x, place.center().y()));
        }
        EXPECT_GT(colors.size(), 10U);
      }
    }
  }
}

TEST_F(PatternEditor, PatternsShowWhatTheirOptionsAskFor)
{
  this->drawTutorial();
  const std::string path = this->file("editor_options.svg");
  const auto exported = [&] {
    EXPECT_TRUE(this->window->savePattern(path)) << this->window->message().toStdString();
    return textOf(path);
  };
  const std::string plain = exported();
  const std::regex spline(" d=\"M[^\"]*C");
  EXPECT_TRUE(std::regex_search(plain, spline));
  vtkPatternWriter* const pattern = this->window->pattern();
  const double usual = pattern->GetFairTolerance();
  pattern->SetFairTolerance(0.3);
  exported();
  EXPECT_TRUE(this->window->message().contains(" of ")) // how many curves in place of edges
    << this->window->message().toStdString();
  pattern->SetFairTolerance(usual);
  const auto answer = [&](bool yes) {
    onDialog<QDialog>(300, [yes](QDialog* dialog) {
      dialog->findChild<QDoubleSpinBox*>("Allowance")->setValue(12.5);
      dialog->findChild<QDoubleSpinBox*>("FairTolerance")->setValue(0.0);
      dialog->findChild<QCheckBox*>("NotchCorners")->setChecked(true);
      dialog->findChild<QLineEdit*>("PatternSize")->setText("XL");
      dialog->findChild<QDoubleSpinBox*>("Quantity")->setValue(3);
      dialog->findChild<QComboBox*>("Paper")->setCurrentText("A0");
      yes ? dialog->accept() : dialog->reject();
    });
    QTest::keyClick(this->window.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QApplication::setActiveWindow(this->window.get()); // the dialog was it
  };
  answer(false);
  EXPECT_EQ(exported(), plain);
  answer(true);
  EXPECT_EQ(pattern->GetAllowance(), 12.5);
  EXPECT_EQ(pattern->GetQuantity(), 3);
  EXPECT_EQ(pattern->GetPaper(), static_cast<int>(vtkPatternWriter::A0));
  EXPECT_TRUE(pattern->GetNotchCorners());
  const std::string asked = exported();
  EXPECT_FALSE(std::regex_search(asked, spline));
  EXPECT_NE(asked.find("XL"), std::string::npos);

  // The fields show what is set.
  onDialog<QDialog>(300, [](QDialog* dialog) {
    EXPECT_EQ(dialog->findChild<QDoubleSpinBox*>("Allowance")->value(), 12.5);
    EXPECT_EQ(dialog->findChild<QComboBox*>("Paper")->currentText(), "A0");
    dialog->findChild<QDoubleSpinBox*>("NotchSpacing")->setValue(0.01);
    dialog->accept();
  });
  QTest::keyClick(this->window.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  QApplication::setActiveWindow(this->window.get());
  EXPECT_FALSE(this->window->savePattern(path));
  EXPECT_TRUE(this->window->message().contains("pattern options"))
    << this->window->message().toStdString();
}

TEST_F(PatternEditor, OneCurveCanHaveOptionsOfItsOwn)
{
  this->drawTutorial();
  vtkPatternWriter* const pattern = this->window->pattern();
  this->fillCurveOptions("boundary", [](QDialog* dialog, QTableWidget* table, int row) {
    EXPECT_GT(table->rowCount(), 2);
    table->item(row, 0)->setText("wide");
    dialog->accept();
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_TRUE(dialog->findChild<QLabel*>("Defect")->text().contains("wide"));
    table->item(row, 0)->setText("20");
    table->item(row, 1)->setText(" 30  60.5 ");
    table->item(row, 2)->setCheckState(Qt::Checked);
    table->item(row, 3)->setText("0.4");
  });
  EXPECT_EQ(pattern->GetCurveAllowance("boundary"), 20.0);
  EXPECT_EQ(pattern->GetNumberOfCurveNotches("boundary"), 2);
  EXPECT_EQ(pattern->GetCurveNotch("boundary", 1), 60.5);
  EXPECT_TRUE(pattern->HasDoubleNotches("boundary"));
  EXPECT_EQ(pattern->GetCurveFairTolerance("boundary"), 0.4);
  EXPECT_FALSE(pattern->HasCurveDartTip("boundary"));
  EXPECT_EQ(pattern->GetCurvesWithOptions()->GetNumberOfValues(), 1);

  // The fields show what is set, and what was emptied is as for all again.
  this->fillCurveOptions("boundary", [](QDialog*, QTableWidget* table, int row) {
    // What is no curve has no ease.
    EXPECT_FALSE(table->item(row, 5)->flags() & Qt::ItemIsEditable);
    EXPECT_EQ(table->item(row, 0)->text(), "20");
    EXPECT_EQ(table->item(row, 1)->text(), "30 60.5");
    table->item(row, 0)->setText("");
  });
  EXPECT_FALSE(pattern->HasCurveAllowance("boundary"));
  EXPECT_EQ(pattern->GetCurveAllowance("boundary"), pattern->GetAllowance());
  EXPECT_TRUE(pattern->HasDoubleNotches("boundary"));
}

TEST_F(PatternEditor, ASavedSurfaceIsTheOneThatWasOpened)
{
  const std::string path = this->file("saved_surface.vtp");
  ASSERT_TRUE(this->window->saveSurface(path)) << this->window->message().toStdString();
  EXPECT_TRUE(this->window->message().contains("saved_surface.vtp"));
  const flattening::DataSet saved = wirewarp::readSurface(path).surface;
  const flattening::DataSet opened = wirewarp::readSurface(shirt).surface;
  EXPECT_TRUE(*saved.points == *opened.points && saved.faces == opened.faces);
  EXPECT_FALSE(this->window->saveSurface("/no such folder/surface.vtp"));
  EXPECT_TRUE(this->window->message().contains("/no such folder"));
  EXPECT_FALSE(EditorWindow().saveSurface(path)); // nothing is open
}

// What the menus lead to, from a window without anything to a pattern on paper.
TEST_F(PatternEditor, ANewUserGetsFromAMeshToAPdfByTheMenus)
{
  const std::string path = this->file("first.pdf");
  this->show();
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  this->picture("empty");
  this->choose(FLATTENING_DATA "/wetsuit_upper_front.vtp");
  QTest::keyClick(this->window.get(), Qt::Key_O, Qt::ControlModifier);
  QApplication::setActiveWindow(this->window.get()); // the dialog was it
  this->surface = this->window->surface();
  ASSERT_NE(this->surface, nullptr) << this->window->message().toStdString();
  this->waitForPieces();
  EXPECT_TRUE(this->window->size().contains("cm")) << this->window->size().toStdString();
  this->picture("opened");
  const double before = this->measure("StrainP95");
  QTest::keyClick(this->window.get(), Qt::Key_F6);
  QApplication::setActiveWindow(this->window.get());
  ASSERT_FALSE(this->window->proposals()->cuts().empty()) << this->window->message().toStdString();
  this->picture("proposed");
  QTest::keyClick(this->window.get(), Qt::Key_F8, Qt::ShiftModifier);
  this->waitForPieces();
  EXPECT_LT(this->measure("StrainP95"), before);
  this->picture("cut");
  this->choose(path);
  QTest::keyClick(this->window.get(), Qt::Key_E, Qt::ControlModifier);
  EXPECT_TRUE(this->window->message().contains("saved")) << this->window->message().toStdString();
  EXPECT_GT(textOf(path).size(), 2000U);
  this->picture("exported");
}

TEST_F(PatternEditor, FilesThatCannotBeReadOrWrittenAreNamed)
{
  const std::string nowhere = "/no such folder/curves.vtp";
  EXPECT_FALSE(this->window->openSurface(nowhere));
  EXPECT_TRUE(this->window->message().contains("/no such folder"));
  EXPECT_FALSE(this->window->saveCurves(nowhere));
  EXPECT_FALSE(this->window->savePattern("/no such folder/pattern.pdf"));
  EXPECT_FALSE(this->window->openSurface(FLATTENING_TUTORIAL));
  EXPECT_TRUE(this->window->message().contains(".vtp"));
  EXPECT_FALSE(this->window->openCurves(shirt)); // no curves
  EXPECT_EQ(this->window->curves()->GetNumberOfCurves(), 0);
}

TEST_F(PatternEditor, SeamsAreTakenFromTheFacesOfAnObjFile)
{
  const std::string file = this->file("labels.obj");
  std::ofstream text(file); // a strip of quads
  for (int i = 0; i < 5; ++i)
  {
    text << "v " << 40 * i << " 0 " << 5 * i * i << "\nv " << 40 * i << " 50 " << 5 * i * i << "\n";
  }
  for (int i = 0; i < 4; ++i)
  {
    text << "g panel" << i << "\nf " << 2 * i + 1 << " " << 2 * i + 3 << " " << 2 * i + 4 << " "
         << 2 * i + 2 << "\n";
  }
  text.close();
  EXPECT_FALSE(this->window->takeSeams(wirewarp::SeamSource::Textures)); // there is no surface
  ASSERT_TRUE(this->window->openSurface(file)) << this->window->message().toStdString();
  vtkFeatureCurveEditor* const curves = this->window->curves();
  ASSERT_TRUE(this->window->takeSeams(wirewarp::SeamSource::Groups))
    << this->window->message().toStdString();
  ASSERT_EQ(curves->GetNumberOfCurves(), 3);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(curves->GetCurveType(k), 3);
    EXPECT_NEAR(curves->GetCurveLength(k), 50.0, 1e-9);
  }
  EXPECT_TRUE(this->window->isWindowModified()); // no file has them
  EXPECT_FALSE(this->window->takeSeams(wirewarp::SeamSource::Textures));
  EXPECT_TRUE(this->window->message().contains("has no texture coordinates"))
    << this->window->message().toStdString();
  EXPECT_EQ(curves->GetNumberOfCurves(), 3);
}

TEST_F(PatternEditor, OfADrawingArcsAreReadAndTheRestIsNamed)
{
  const std::string surfaceFile = this->file("square.obj");
  const std::string path = this->file("drawing.dxf");
  std::ofstream(surfaceFile) << "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nf 1 3 4\n";
  const std::string arc = "0\nARC\n8\nkey hem\n10\n5\n20\n4\n40\n3\n50\n10\n51\n190\n";
  for (const bool hatched : { false, true })
  {
    ASSERT_TRUE(this->window->openSurface(surfaceFile)) << this->window->message().toStdString();
    std::ofstream(path) << "0\nSECTION\n2\nENTITIES\n"
                        << arc << (hatched ? "0\nHATCH\n5\n2F\n8\nfilled\n" : "")
                        << "0\nENDSEC\n0\nEOF\n";
    ASSERT_TRUE(this->window->openCurves(path)) << this->window->message().toStdString();
    ASSERT_EQ(this->window->curves()->GetNumberOfCurves(), 1);
    EXPECT_EQ(this->window->curves()->GetCurveName(0), "hem");
    EXPECT_NEAR(this->window->curves()->GetCurveLength(0), 3.0 * std::acos(-1.0), 1e-3);
    EXPECT_EQ(this->window->message().contains("HATCH (line 20, handle 2F)"), hatched)
      << this->window->message().toStdString();
    EXPECT_EQ(this->window->message().isEmpty(), !hatched);
  }
}

TEST_F(PatternEditor, WhatCannotBeDoneYetCannotBePressed)
{
  const auto isEnabled = [](const EditorWindow& shown, const QString& words) {
    for (const QToolBar* bar : shown.findChildren<QToolBar*>())
    {
      for (const QAction* action : bar->actions())
      {
        if (action->text().startsWith(words))
        {
          return action->isEnabled();
        }
      }
    }
    ADD_FAILURE() << words.toStdString() << " is not in the bar";
    return false;
  };
  const EditorWindow empty;
  EXPECT_TRUE(isEnabled(empty, "Open surface"));
  for (const char* words : { "Propose cuts", "Offset by", "Save curves", "Export pattern" })
  {
    EXPECT_FALSE(isEnabled(empty, words)) << words;
  }
  EXPECT_TRUE(isEnabled(*this->window, "Propose cuts"));
  EXPECT_TRUE(isEnabled(*this->window, "Export pattern"));
  EXPECT_FALSE(isEnabled(*this->window, "Offset by")); // of no curve
  this->draw({ 401, 6 });
  EXPECT_TRUE(isEnabled(*this->window, "Offset by"));
}

TEST_F(PatternEditor, ThePanelOffersWhatTheBarOffers)
{
  this->draw({ 401, 6 });
  editor::CurvePanel* const panel = this->window->panel();
  const auto expectTheSame = [&] {
    EXPECT_EQ(panel->mirrored()->isEnabled(), this->window->action(Hand::MIRROR)->isEnabled());
    EXPECT_EQ(panel->mirrored()->isChecked(), this->window->action(Hand::MIRROR)->isChecked());
    EXPECT_EQ(
      panel->straight()->isEnabled(), this->window->action(Hand::STRAIGHT_KEY)->isEnabled());
  };
  expectTheSame();
  EXPECT_TRUE(panel->mirrored()->isEnabled()); // the plane is found when it is asked for
  panel->mirrored()->click();
  EXPECT_TRUE(this->window->curves()->GetCurveMirrored(0));
  expectTheSame();
  this->push(Hand::MAKE_KEY);
  expectTheSame();
  EXPECT_TRUE(panel->straight()->isEnabled());
  EXPECT_TRUE(panel->length().endsWith(" cm")) << panel->length().toStdString();
  this->window->unit()->setCurrentText("mm");
  EXPECT_TRUE(panel->length().endsWith(" mm"));
  EXPECT_TRUE(panel->list()->item(0)->text().endsWith(" mm"));
  EXPECT_TRUE(QString(this->window->hand()->GetHint()).contains(" mm, 2 nodes"))
    << this->window->hand()->GetHint();
}

TEST_F(PatternEditor, WhatIsBeingDrawnIsAsLongAsTheMouseSaysInTheUnitChosen)
{
  this->window->unit()->setCurrentText("inch");
  this->push(Hand::NEW_CURVE);
  this->click(this->vertex(6));
  this->moveTo(this->vertex(7));
  std::string shown;
  vtkRendererCollection* const views = this->window->spaceWidget()->renderWindow()->GetRenderers();
  for (int view = 0; view < views->GetNumberOfItems(); ++view)
  {
    shown += textsOf(static_cast<vtkRenderer*>(views->GetItemAsObject(view)));
  }
  EXPECT_NE(shown.find(" inch"), std::string::npos) << shown;
}
