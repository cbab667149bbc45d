// SPDX-License-Identifier: BSD-3-Clause
// Clicks and keys as the window gets them from the X server, with what must come of them.
#include "PatternWindow.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFeatureCurveImprinter.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

using namespace viewer;

namespace
{
using Pixels = std::vector<unsigned char>;

class PatternViewer : public testing::Test
{
protected:
  void SetUp() override
  {
    this->prefix = testing::TempDir() + "viewer_" +
      testing::UnitTest::GetInstance()->current_test_info()->name();
    const figures::Piece piece = figures::readPiece(FLATTENING_DATA, "shirt_front");
    this->model = std::make_unique<PatternModel>(piece.surface, piece.curves, nullptr);
    this->model->filter()->SetSchemeToGlobal();
    this->model->flatten();
    this->open(*this->model);
  }

  void TearDown() override
  {
    for (const char* end : { ".png", ".svg", "_curves.vtp", "_released.vtp" })
    {
      std::remove((this->prefix + end).c_str());
    }
  }

  void open(PatternModel& shown)
  {
    WindowOptions options;
    options.width = 1000;
    options.height = 700;
    options.samples = 0;
    options.title = "shirt";
    options.prefix = this->prefix;
    this->window = std::make_unique<PatternWindow>(shown, options);
    this->window->picture().window()->SetOffScreenRendering(1);
    this->window->open();
  }

  int curve(const std::string& name) const
  {
    for (int k = 0; k < this->model->numberOfCurves(); ++k)
    {
      if (this->model->curveName(k) == name)
      {
        return k;
      }
    }
    ADD_FAILURE() << "no curve " << name;
    return 0;
  }

  /// Where the middle of one of a curve's edges is in the window.
  std::array<int, 2> place(int id, bool inPlane, double fraction) const
  {
    const std::vector<Segment> segments = this->model->segments(id, inPlane);
    const Segment& segment = segments[static_cast<std::size_t>(fraction * segments.size())];
    vtkRenderer* const renderer =
      inPlane ? this->window->picture().plane() : this->window->picture().space();
    renderer->SetWorldPoint(0.5 * (segment.start[0] + segment.end[0]),
      0.5 * (segment.start[1] + segment.end[1]), 0.5 * (segment.start[2] + segment.end[2]), 1.0);
    renderer->WorldToDisplay();
    const double* const point = renderer->GetDisplayPoint();
    return { static_cast<int>(std::lround(point[0])), static_cast<int>(std::lround(point[1])) };
  }

  void drag(const std::array<int, 2>& from, const std::array<int, 2>& to)
  {
    vtkRenderWindowInteractor* const interactor = this->window->interactor();
    interactor->SetEventInformation(from[0], from[1]);
    interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    interactor->SetEventInformation(to[0], to[1]);
    interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
    interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  }
  void click(const std::array<int, 2>& at) { this->drag(at, at); }

  void press(char key)
  {
    vtkRenderWindowInteractor* const interactor = this->window->interactor();
    interactor->SetKeyCode(key);
    interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    interactor->InvokeEvent(vtkCommand::CharEvent);
    interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
  }

  Pixels pixels() const
  {
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(this->window->picture().window());
    image->ReadFrontBufferOff();
    image->Update();
    auto* const values =
      vtkUnsignedCharArray::SafeDownCast(image->GetOutput()->GetPointData()->GetScalars());
    return { values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues() };
  }

  /// Lengths of the wires in the plane, edge by edge, are those on the surface.
  void expectExactLengths() const
  {
    const figures::FlatPiece& piece = this->model->result();
    vtkNew<vtkIdList> ids;
    ASSERT_GT(piece.wires->GetNumberOfCells(), 0);
    for (vtkIdType cell = 0; cell < piece.wires->GetNumberOfCells(); ++cell)
    {
      piece.wires->GetCellPoints(cell, ids);
      for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
      {
        const auto length = [&](vtkPolyData* data) {
          double a[3];
          double b[3];
          data->GetPoint(ids->GetId(k), a);
          data->GetPoint(ids->GetId(k + 1), b);
          return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        };
        EXPECT_NEAR(length(piece.flat) / length(piece.cut), 1.0, 1e-10);
      }
    }
  }

  /// Types of the wires by the curve's name, as the filter reports them.
  std::map<std::string, int> wireTypes() const
  {
    vtkFieldData* const rows = this->model->result().wires->GetFieldData();
    auto* const names = vtkStringArray::SafeDownCast(rows->GetAbstractArray("CurveNames"));
    std::map<std::string, int> types;
    for (vtkIdType row = 0; row < names->GetNumberOfValues(); ++row)
    {
      types[names->GetValue(row)] =
        static_cast<int>(rows->GetArray("CurveTypes")->GetComponent(row, 0));
    }
    return types;
  }

  std::string prefix;
  std::unique_ptr<PatternModel> model;
  std::unique_ptr<PatternWindow> window;
};

std::string contents(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

PolyData read(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}
}

//------------------------------------------------------------------------------
TEST_F(PatternViewer, ClicksOnACurveInSpaceMakeItKeyThenReleasedThenAccessory)
{
  const int bust = this->curve("bust_girth");
  ASSERT_EQ(this->model->role(bust), Role::Accessory);
  Pixels before = this->pixels();
  const auto initial = this->wireTypes();
  for (const Role role : { Role::Key, Role::Released, Role::Accessory })
  {
    this->click(this->place(bust, false, 0.4));
    EXPECT_EQ(this->model->role(bust), role);
    const auto types = this->wireTypes();
    EXPECT_EQ(types.count("bust_girth"), role == Role::Released ? 0 : 1);
    if (role == Role::Key)
    {
      EXPECT_EQ(types.at("bust_girth"), vtkWireWarpingFilter::KEY);
    }
    this->expectExactLengths();
    const Pixels after = this->pixels();
    EXPECT_NE(after, before);
    before = after;
  }
  EXPECT_EQ(this->wireTypes(), initial);
}

TEST_F(PatternViewer, AClickOnACurveInThePlaneChangesIt)
{
  const int centre = this->curve("centre_front");
  ASSERT_EQ(this->model->role(centre), Role::Key);
  this->click(this->place(centre, true, 0.2));
  EXPECT_EQ(this->model->role(centre), Role::Released);
  this->expectExactLengths();
}

TEST_F(PatternViewer, WhatIsPrescribedCostsAngles)
{
  const double before = this->model->result().number("Objective");
  this->click(this->place(this->curve("bust_girth"), false, 0.4));
  EXPECT_GT(this->model->result().number("Objective"), before);
  EXPECT_EQ(this->window->message(), "bust_girth is key");
}

TEST_F(PatternViewer, KeysThatCannotKeepTheirShapesTogetherAreNamed)
{
  this->click(this->place(this->curve("waist_girth"), false, 0.4));
  EXPECT_NE(this->window->message().find("waist_girth is key; "), std::string::npos);
  EXPECT_NE(this->window->message().find("centre_front"), std::string::npos);
  this->expectExactLengths();
}

TEST_F(PatternViewer, AReleasedCurveCanBePickedAgainInBothViews)
{
  const int waist = this->curve("waist_girth");
  for (const bool inPlane : { false, true })
  {
    this->click(this->place(waist, false, 0.4));
    this->click(this->place(waist, false, 0.4));
    ASSERT_EQ(this->model->role(waist), Role::Released);
    this->click(this->place(waist, inPlane, 0.4));
    EXPECT_EQ(this->model->role(waist), Role::Accessory);
  }
}

TEST_F(PatternViewer, DartsAndEmptyPlacesStayAsTheyAre)
{
  const Pixels before = this->pixels();
  this->click({ 2, 690 });
  EXPECT_EQ(this->pixels(), before);
  const int dart = this->curve("bust_dart_left");
  this->click(this->place(dart, true, 0.5));
  EXPECT_EQ(this->model->role(dart), Role::Cut);
  EXPECT_NE(this->window->message().find("bust_dart_left is cut"), std::string::npos);
}

TEST_F(PatternViewer, ADragTurnsOneViewAndChangesNoCurve)
{
  const auto types = this->wireTypes();
  vtkCamera* const space = this->window->picture().space()->GetActiveCamera();
  vtkCamera* const plane = this->window->picture().plane()->GetActiveCamera();
  const std::array<double, 3> spaceBefore{ space->GetPosition()[0], space->GetPosition()[1],
    space->GetPosition()[2] };
  const std::array<double, 3> planeBefore{ plane->GetPosition()[0], plane->GetPosition()[1],
    plane->GetPosition()[2] };
  const std::array<int, 2> from = this->place(this->curve("waist_girth"), false, 0.4);
  this->drag(from, { from[0] + 60, from[1] + 20 });
  EXPECT_NE(space->GetPosition()[0], spaceBefore[0]);
  EXPECT_EQ(plane->GetPosition()[0], planeBefore[0]);
  EXPECT_EQ(this->wireTypes(), types);

  // The plane is moved, and stays the plane.
  const std::array<int, 2> flat = this->place(this->curve("waist_girth"), true, 0.4);
  this->drag(flat, { flat[0] + 40, flat[1] });
  EXPECT_NE(plane->GetPosition()[0], planeBefore[0]);
  EXPECT_DOUBLE_EQ(plane->GetDirectionOfProjection()[2], -1.0);

  // A change keeps the views as the user left them.
  const double turned = space->GetPosition()[0];
  this->click(this->place(this->curve("waist_girth"), true, 0.4));
  EXPECT_EQ(this->window->picture().space()->GetActiveCamera()->GetPosition()[0], turned);
  this->press('r');
  EXPECT_NEAR(
    this->window->picture().space()->GetActiveCamera()->GetPosition()[0], spaceBefore[0], 1e-9);
}

TEST_F(PatternViewer, WhatTheSurfaceHidesCannotBePicked)
{
  // From the side, both curves of the symmetric shirt are drawn in one place.
  const int left = this->curve("princess_left");
  const int right = this->curve("princess_right");
  vtkCamera* const camera = this->window->picture().space()->GetActiveCamera();
  for (const double turn : { 75.0, -150.0 })
  {
    camera->Azimuth(turn);
    const bool leftIsNear =
      camera->GetPosition()[0] * this->model->segments(left, false)[8].start[0] > 0.0;
    const int near = leftIsNear ? left : right;
    const int far = leftIsNear ? right : left;
    const Role nearBefore = this->model->role(near);
    const Role farBefore = this->model->role(far);
    this->click(this->place(far, false, 0.7));
    EXPECT_EQ(this->model->role(far), farBefore);
    this->click(this->place(near, false, 0.7));
    EXPECT_NE(this->model->role(near), nearBefore);
  }
}

TEST_F(PatternViewer, AnotherSizeLeavesTheWordsTheirPlace)
{
  vtkRenderWindow* const shown = this->window->picture().window();
  const double words = this->window->picture().space()->GetViewport()[1] * shown->GetSize()[1];
  shown->SetSize(800, 900);
  this->window->interactor()->InvokeEvent(vtkCommand::ConfigureEvent);
  EXPECT_NEAR(this->window->picture().space()->GetViewport()[1] * 900.0, words, 1e-6);
  const int waist = this->curve("waist_girth");
  this->click(this->place(waist, true, 0.4));
  EXPECT_EQ(this->model->role(waist), Role::Key);
}

TEST_F(PatternViewer, KeysChangeTheColours)
{
  Pixels last = this->pixels();
  for (const char key : { '1', '3', '4', '2' })
  {
    this->press(key);
    EXPECT_EQ(this->window->coloring(), figures::colorings[key - '1']);
    const Pixels now = this->pixels();
    EXPECT_NE(now, last);
    last = now;
  }
}

TEST_F(PatternViewer, KeysSavePictureAndPattern)
{
  this->press('p');
  EXPECT_EQ(contents(this->prefix + ".png").substr(1, 3), "PNG");
  this->press('s');
  const std::string svg = contents(this->prefix + ".svg");
  EXPECT_NE(svg.find("cut-line"), std::string::npos);
  EXPECT_NE(svg.find("data-curve=\"waist_girth\""), std::string::npos);
  EXPECT_NE(this->window->message().find(".svg"), std::string::npos);
}

TEST_F(PatternViewer, TheSavedStateComesBack)
{
  this->click(this->place(this->curve("waist_girth"), false, 0.4));
  this->click(this->place(this->curve("centre_front"), true, 0.2));
  this->press('c');
  const auto types = this->wireTypes();
  const double objective = this->model->result().number("Objective");

  const figures::Piece piece = figures::readPiece(FLATTENING_DATA, "shirt_front");
  PatternModel again(
    piece.surface, read(this->prefix + "_curves.vtp"), read(this->prefix + "_released.vtp"));
  again.filter()->SetSchemeToGlobal();
  again.flatten();
  ASSERT_EQ(again.numberOfCurves(), this->model->numberOfCurves());
  for (int k = 0; k < again.numberOfCurves(); ++k)
  {
    EXPECT_EQ(again.role(k), this->model->role(this->curve(again.curveName(k))));
  }
  EXPECT_NEAR(again.result().number("Objective"), objective, 1e-9);
}

TEST_F(PatternViewer, AFileThatCannotBeWrittenIsSaidInTheCorner)
{
  this->prefix = "/no such folder/shirt";
  this->open(*this->model);
  for (const char key : { 'p', 's', 'c' })
  {
    this->press(key);
    EXPECT_NE(this->window->message().find("cannot"), std::string::npos) << key;
  }
}
