// SPDX-License-Identifier: BSD-3-Clause
// What PatternEditor does so that no curve is lost: marks, the journal, and files too large.
#include "EditorSession.h"

#include <QComboBox>
#include <QDir>
#include <QMessageBox>
#include <QStandardPaths>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

using namespace session;

namespace
{
int filesSynced = 0;
}

/// In place of the system's, which it calls.
extern "C" int fsync(int file)
{
  ++filesSynced;
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace
{
/// A curve over the surface between two of its points, and what follows a change.
void addLine(EditorWindow* window, vtkIdType from, vtkIdType to)
{
  ASSERT_TRUE(window->curves()->AddCurve(pointsAt(window->surface(), { from, to })))
    << window->curves()->GetMessage();
  QApplication::processEvents();
}

std::vector<double> lengths(EditorWindow* window)
{
  std::vector<double> found;
  for (int k = 0; k < window->curves()->GetNumberOfCurves(); ++k)
  {
    found.push_back(window->curves()->GetCurveLength(k));
  }
  return found;
}

/// The files of unsaved curves.
QStringList journals()
{
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
    "/patterneditor/unsaved");
  return folder.entryList({ "*.vtp" }, QDir::Files);
}

/// Presses a button of the next question. \param asked gets what it says
void answer(QMessageBox::StandardButton button, QString& asked)
{
  onDialog<QMessageBox>(300, [button, &asked](QMessageBox* box) {
    asked = box->text();
    box->button(button)->click();
  });
}
}

TEST_F(PatternEditor, WhatIsNotSavedIsMarkedInTheTitle)
{
  const std::string path = this->file("marked.vtp");
  EXPECT_TRUE(this->window->windowTitle().startsWith("shirt_front[*]"));
  EXPECT_FALSE(this->window->isWindowModified());
  addLine(this->window.get(), 6, 7);
  EXPECT_TRUE(this->window->isWindowModified());
  ASSERT_TRUE(this->window->saveCurves(path)) << this->window->message().toStdString();
  EXPECT_FALSE(this->window->isWindowModified());
  this->window->curves()->SetCurveName(0, "waist");
  EXPECT_TRUE(this->window->isWindowModified());
  EXPECT_FALSE(this->window->saveCurves("/no such folder/marked.vtp"));
  EXPECT_TRUE(this->window->isWindowModified());
  ASSERT_TRUE(this->window->openCurves(path));
  EXPECT_FALSE(this->window->isWindowModified());
  addLine(this->window.get(), 6, 7);
  ASSERT_TRUE(this->window->openSurface(FLATTENING_DATA "/quarter_sphere.vtp"));
  EXPECT_FALSE(this->window->isWindowModified());
}

TEST_F(PatternEditor, WhatASlotThrowsIsAMessageAndTheCurvesStay)
{
  addLine(this->window.get(), 6, 7);
  const std::vector<double> drawn = lengths(this->window.get());
  QAction chosen("a slot", nullptr);
  const auto fail = [](const std::string& how) {
    if (how == "memory ran out")
    {
      throw std::bad_alloc();
    }
    throw std::runtime_error(how);
  };
  for (const std::string how : { "memory ran out", "a filter failed" })
  {
    for (const bool timer : { false, true })
    {
      QTimer::singleShot(0, [&] {
        if (timer)
        {
          fail(how);
        }
        chosen.trigger();
      });
      const QMetaObject::Connection connection =
        QObject::connect(&chosen, &QAction::triggered, [&] { fail(how); });
      QTest::qWait(50);
      QObject::disconnect(connection);
      EXPECT_TRUE(this->window->message().contains(QString::fromStdString(how)))
        << this->window->message().toStdString();
      EXPECT_EQ(lengths(this->window.get()), drawn);
    }
  }
  addLine(this->window.get(), 8, 9);
  EXPECT_EQ(lengths(this->window.get()).size(), drawn.size() + 1);
}

TEST_F(PatternEditor, UnsavedCurvesAreOnTheDiskBeforeTheyReplaceEarlierOnes)
{
  const std::string path = this->file("synced.vtp");
  for (int k = 0; k < 3; ++k)
  {
    addLine(this->window.get(), 6, 7 + k);
    filesSynced = 0;
    ASSERT_TRUE(this->window->saveCurves(path));
    EXPECT_GE(filesSynced, 1);
    filesSynced = 0;
    addLine(this->window.get(), 20, 30 + k);
    QTest::qWait(1500); // until the journal has it
    EXPECT_GE(filesSynced, 1);
  }
}

TEST_F(PatternEditor, AFileTooLargeForTheMemoryIsAMessageAndTheCurvesStay)
{
  addLine(this->window.get(), 6, 7);
  const std::vector<double> drawn = lengths(this->window.get());
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  for (const char* name : { "huge.obj", "huge.off", "huge.ply" })
  {
    const std::string path = this->file(name);
    std::ofstream(path) << "ply\nformat ascii 1.0\n";
    std::filesystem::resize_file(path, 3900000000); // of which the disk holds a block
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit less = before;
    less.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + (1U << 30);
    ASSERT_EQ(setrlimit(RLIMIT_AS, &less), 0);
    EXPECT_FALSE(this->window->openSurface(path));
    ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
    EXPECT_TRUE(this->window->message().contains("memory ran out"))
      << this->window->message().toStdString();
    EXPECT_EQ(lengths(this->window.get()), drawn);
  }
}

TEST_F(PatternEditor, ProposalsThatAreAcceptedWhileACurveIsDrawnAreUndoneAtOnce)
{
  addLine(this->window.get(), 6, 7);
  editor::ProposalBox* const box = this->window->proposals();
  const auto proposal = [this](const std::string& name, vtkIdType from, vtkIdType to) {
    editor::Proposal cut;
    cut.name = name;
    cut.type = 2;
    cut.points = pointsAt(this->surface, { from, to });
    cut.length = 1.0;
    return cut;
  };
  vtkFeatureCurveEditor* const curves = this->window->curves();
  // What is being drawn is undone by itself.
  this->push(Hand::NEW_CURVE);
  this->clickSeen(tutorialCurves()[0].vertices[0]);
  this->clickSeen(tutorialCurves()[0].vertices[1]);
  box->set({ { proposal("left", 10, 11), proposal("right", 20, 21), proposal("back", 30, 31) }, {},
    false, {} });
  QTest::keyClick(this->window.get(), Qt::Key_F8, Qt::ShiftModifier);
  EXPECT_EQ(curves->GetNumberOfCurves(), 5);
  QTest::keyClick(this->window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(curves->GetNumberOfCurves(), 2);
  QTest::keyClick(this->window.get(), Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(curves->GetNumberOfCurves(), 5);
}

TEST_F(PatternEditor, CurvesOfAWindowThatEndedWithoutClosingAreOfferedOnTheSameSurface)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto drawAndCrash = [this] {
    this->window->unit()->setCurrentText("m");
    addLine(this->window.get(), 6, 7);
    addLine(this->window.get(), 6, 60);
    this->window->curves()->SetCurveType(1, 2);
    this->window->curves()->SetCurveName(1, "left dart");
    QTest::qWait(1000);
    std::raise(SIGKILL);
  };
  EXPECT_TRUE(journals().isEmpty());
  EXPECT_EXIT(drawAndCrash(), testing::KilledBySignal(SIGKILL), "");
  ASSERT_EQ(journals().size(), 1);

  // Neither on another surface nor while it is not answered is anything done with them.
  ASSERT_TRUE(this->window->openSurface(FLATTENING_DATA "/quarter_sphere.vtp"));
  EXPECT_EQ(this->window->curves()->GetNumberOfCurves(), 0);
  ASSERT_EQ(journals().size(), 1);

  // The same surface under another name.
  const std::string copy = this->file("copy_of_shirt.vtp");
  std::filesystem::copy_file(shirt, copy, std::filesystem::copy_options::overwrite_existing);
  QString asked;
  answer(QMessageBox::Yes, asked);
  ASSERT_TRUE(this->window->openSurface(copy));
  EXPECT_TRUE(asked.contains("not saved")) << asked.toStdString();
  vtkFeatureCurveEditor* const curves = this->window->curves();
  ASSERT_EQ(curves->GetNumberOfCurves(), 2);
  EXPECT_EQ(curves->GetCurveName(1), "left dart");
  EXPECT_EQ(curves->GetCurveType(1), 2);
  EXPECT_EQ(curves->GetNumberOfNodes(1), 2); // with their nodes, to go on from
  EXPECT_EQ(this->window->unit()->currentText(), "m");
  EXPECT_TRUE(this->window->isWindowModified());
  QTest::qWait(1000);
  EXPECT_EQ(journals().size(), 1);

  // Saved, they are not kept any more, and not asked for again.
  const std::string path = this->file("recovered.vtp");
  ASSERT_TRUE(this->window->saveCurves(path));
  EXPECT_TRUE(journals().isEmpty());
  ASSERT_TRUE(this->window->openSurface(shirt));
  EXPECT_EQ(curves->GetNumberOfCurves(), 0);
}

TEST_F(PatternEditor, CurvesThatAreDiscardedAreNotOfferedAgainAndAWindowThatClosesLeavesNone)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto drawAndCrash = [this] {
    addLine(this->window.get(), 6, 7);
    QTest::qWait(1000);
    std::raise(SIGSEGV);
  };
  EXPECT_EXIT(drawAndCrash(), testing::KilledBySignal(SIGSEGV), "");
  ASSERT_EQ(journals().size(), 1);
  QString asked;
  answer(QMessageBox::Discard, asked);
  ASSERT_TRUE(this->window->openSurface(shirt));
  EXPECT_FALSE(asked.isEmpty());
  EXPECT_EQ(this->window->curves()->GetNumberOfCurves(), 0);
  EXPECT_TRUE(journals().isEmpty());
  ASSERT_TRUE(this->window->openSurface(shirt));

  // Two windows on one surface keep their curves apart.
  EditorWindow second;
  ASSERT_TRUE(second.openSurface(shirt));
  addLine(this->window.get(), 6, 7);
  addLine(&second, 6, 60);
  QTest::qWait(1000);
  EXPECT_EQ(journals().size(), 2);
  this->window.reset();
  EXPECT_EQ(journals().size(), 1);
}
