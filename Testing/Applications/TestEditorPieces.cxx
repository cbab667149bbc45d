// SPDX-License-Identifier: BSD-3-Clause
// Numbers and pieces of PatternEditor while the curves are already others.
#include "EditorSession.h"
#include "Sheet.h"
#include "StraightCorners.h"

#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <QLabel>

#include <filesystem>

using namespace session;

namespace
{
constexpr int squares = 300; // 180,000 triangles: no draft of them comes at once

class EditorPieces : public PatternEditor
{
protected:
  void addCurve(double x)
  {
    ASSERT_TRUE(this->window->curves()->AddCurve(
      pointsAt({ { x, 0.2, sheets::bulge(x, 0.2) }, { x, 0.8, sheets::bulge(x, 0.8) } })))
      << this->window->curves()->GetMessage();
  }

  bool areGrey() const { return !this->window->measures()->isEnabled(); }
  QString words() const { return this->window->measures()->text(); }
  double opacity() const
  {
    vtkActorCollection* const actors = this->window->plane()->GetActors();
    actors->InitTraversal();
    return actors->GetNextActor()->GetProperty()->GetOpacity();
  }
};
}

TEST_F(EditorPieces, NumbersOfEarlierCurvesAreGreyUntilThoseOfTheNewOnesAreThere)
{
  ASSERT_TRUE(this->window->openSurface(this->write(sheets::sheet(squares), "sheet.vtp")));
  EXPECT_TRUE(this->words().isEmpty());
  ASSERT_TRUE(QTest::qWaitFor(
    [this] { return this->words().contains("flattening") || !this->window->isWaiting(); }, 60000));
  EXPECT_TRUE(this->words().contains("flattening")) << this->words().toStdString();
  this->waitForPieces();
  EXPECT_FALSE(this->areGrey());
  const QString first = this->words();
  ASSERT_TRUE(first.contains("E_area")) << first.toStdString();

  // While anything is waited for they may become grey, and black again only when they are of the
  // curves as they are.
  const auto becomeGrey = [this] {
    bool grey = this->areGrey();
    const auto look = [&] {
      grey = grey || this->areGrey();
      EXPECT_EQ(this->areGrey(), this->words().contains("recomputing"));
      EXPECT_EQ(this->areGrey(), this->opacity() < 0.9);
      return !this->window->isWaiting();
    };
    EXPECT_TRUE(QTest::qWaitFor(look, 60000));
    return grey;
  };
  this->addCurve(0.5);
  EXPECT_TRUE(becomeGrey());
  EXPECT_FALSE(this->areGrey());
  EXPECT_NE(this->words(), first);
  EXPECT_FALSE(this->words().contains("(")) << this->words().toStdString();
  ASSERT_TRUE(this->window->curves()->SetCurveType(0, 1));
  becomeGrey(); // unless that goes faster than the eye sees
  EXPECT_FALSE(this->areGrey());
}

TEST_F(EditorPieces, OfWhatIsRejectedThereAreNoNumbersAndNoPattern)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(10.0);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(17);
  ball->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  ball->Update();
  ASSERT_TRUE(this->window->openSurface(this->write(ball->GetOutput(), "ball.vtp")));
  this->waitForPieces();
  EXPECT_TRUE(this->window->message().contains("closed")) << this->window->message().toStdString();
  EXPECT_EQ(this->words(), "");
  vtkFeatureCurveEditor* const curves = this->window->curves();
  ASSERT_TRUE(
    curves->AddCurve(pointsAt({ { 0.0, 0.0, 10.0 }, { 10.0, 0.0, 0.0 }, { 0.0, 0.0, -10.0 } })));
  ASSERT_TRUE(curves->SetCurveType(0, 2));
  this->waitForPieces();
  EXPECT_FALSE(this->areGrey());
  const std::string pattern = this->file("pattern.svg");
  EXPECT_TRUE(this->window->savePattern(pattern)) << this->window->message().toStdString();
  EXPECT_TRUE(std::filesystem::remove(pattern));

  ASSERT_TRUE(curves->SetCurveType(0, 0)); // nothing opens it any more
  this->waitForPieces();
  EXPECT_TRUE(this->areGrey());
  EXPECT_TRUE(this->words().contains("rejected")) << this->words().toStdString();
  EXPECT_FALSE(this->words().contains("recomputing")) << this->words().toStdString();
  EXPECT_FALSE(this->window->savePattern(pattern));
  EXPECT_TRUE(this->window->message().contains("closed")) << this->window->message().toStdString();
  EXPECT_FALSE(std::filesystem::exists(pattern));
  curves->Undo();
  this->waitForPieces();
  EXPECT_FALSE(this->areGrey());
}

TEST_F(EditorPieces, AKeyWithACornerThatIsToBeStraightIsNamedWhateverBecomesOfItsPiece)
{
  vtkFeatureCurveEditor* const curves = this->window->curves();
  // To the middle of the front and up to the neck.
  ASSERT_TRUE(curves->AddCurve(pointsAt(this->surface, { 401, 6, 5 })));
  ASSERT_TRUE(curves->SetCurveType(0, 1));
  ASSERT_TRUE(curves->SetCurveKeyShape(0, 1));
  int broken = 0;
  for (int kind = 0; kind < 4; ++kind)
  {
    for (int segment = 0; segment < 2; ++segment)
    {
      ASSERT_TRUE(curves->SetSegmentKind(0, segment, kind)) << curves->GetMessage();
    }
    this->waitForPieces();
    const std::string words = this->window->message().toStdString();
    EXPECT_EQ(editor::cornersOfStraightKeys(curves).find("\"curve 1\" cannot be straight"), 0U);
    if (!words.empty())
    {
      ++broken;
      EXPECT_EQ(words, editor::cornersOfStraightKeys(curves));
      EXPECT_NE(words.find("at its node 2; split it there [X]"), std::string::npos) << words;
    }
  }
  EXPECT_GE(broken, 1);
  // What it says helps.
  ASSERT_TRUE(curves->SplitCurve(0, 1));
  this->waitForPieces();
  EXPECT_EQ(editor::cornersOfStraightKeys(curves), "");
  EXPECT_EQ(this->window->message(), "");
  // A curve without a corner has none, and a closed one is none that can be straight.
  ASSERT_TRUE(curves->AddCurve(pointsAt(this->surface, { 401, 12, 5 })));
  ASSERT_TRUE(curves->SetCurveType(2, 1));
  ASSERT_TRUE(curves->SetCurveClosed(2, true));
  ASSERT_TRUE(curves->SetCurveKeyShape(2, 1));
  EXPECT_NE(editor::cornersOfStraightKeys(curves).find("is closed"), std::string::npos);
}

TEST_F(EditorPieces, TheScaleOfColorsLiesBesideThePiece)
{
  this->waitForPieces();
  vtkRenderer* const plane = this->window->plane();
  const double* const bounds = this->window->planeView().shown().flat->GetBounds();
  plane->SetWorldPoint(bounds[0], bounds[2], 0.0, 1.0);
  plane->WorldToDisplay();
  const double height = plane->GetSize()[1];
  EXPECT_GT(plane->GetDisplayPoint()[1], 0.1 * height); // where its title ends
  plane->SetWorldPoint(bounds[1], bounds[3], 0.0, 1.0);
  plane->WorldToDisplay();
  EXPECT_LT(plane->GetDisplayPoint()[1], height);
  EXPECT_LT(plane->GetDisplayPoint()[0], plane->GetSize()[0]);
}
