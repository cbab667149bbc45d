// SPDX-License-Identifier: BSD-3-Clause
// A scene that is drawn once gives the picture of one that is drawn each time, also where what
// moves before it goes behind it.
#include <vtkStillRenderer.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{
constexpr int width = 240;
constexpr int height = 180;

/// A ball that stands still, and a line that moves and pierces it.
struct Scene
{
  explicit Scene(bool still)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    if (still)
    {
      this->Back = this->Still;
      this->Window->SetNumberOfLayers(2);
      this->Window->AddRenderer(this->Still);
      this->Window->AddRenderer(this->Front);
      this->Front->SetLayer(1);
      this->Front->PreserveDepthBufferOn();
      this->Front->SetActiveCamera(this->Still->GetActiveCamera());
    }
    else
    {
      this->Back = this->Front;
      this->Window->AddRenderer(this->Front);
    }
    this->Back->SetBackground(1.0, 0.9, 0.8);
    this->Ball->SetThetaResolution(24);
    this->BallMapper->SetInputConnection(this->Ball->GetOutputPort());
    this->BallActor->SetMapper(this->BallMapper);
    this->Back->AddActor(this->BallActor);
    this->LineMapper->SetInputConnection(this->Line->GetOutputPort());
    this->LineActor->SetMapper(this->LineMapper);
    this->LineActor->GetProperty()->SetLineWidth(5.0F);
    this->LineActor->GetProperty()->SetColor(0.8, 0.0, 0.0);
    this->LineActor->GetProperty()->LightingOff();
    this->Front->AddActor(this->LineActor);
    vtkCamera* const camera = this->Back->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 4.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetClippingRange(1.0, 10.0);
  }

  void moveLine(double by)
  {
    this->Line->SetPoint1(-1.0, -0.8 + by, -1.0);
    this->Line->SetPoint2(1.0, 0.5 + by, 1.0);
  }
  std::vector<unsigned char> picture()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* const size = this->Window->GetSize();
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkStillRenderer> Still;
  vtkNew<vtkRenderer> Front;
  vtkRenderer* Back = nullptr;
  vtkNew<vtkSphereSource> Ball;
  vtkNew<vtkPolyDataMapper> BallMapper;
  vtkNew<vtkActor> BallActor;
  vtkNew<vtkLineSource> Line;
  vtkNew<vtkPolyDataMapper> LineMapper;
  vtkNew<vtkActor> LineActor;
};
}

TEST(StillRenderer, APictureThatIsKeptIsThatOfASceneDrawnEachTime)
{
  Scene still(true);
  Scene drawn(false);
  std::vector<unsigned char> last;
  for (int k = 0; k < 5; ++k)
  {
    still.moveLine(0.1 * k);
    drawn.moveLine(0.1 * k);
    still.Back->SetDisplayPoint(3.0, 4.0, 0.0); // as a pick of a place in the window does
    const std::vector<unsigned char> picture = still.picture();
    EXPECT_TRUE(picture == drawn.picture()) << k;
    EXPECT_FALSE(picture == last);
    last = picture;
  }
  EXPECT_EQ(still.Still->GetNumberOfDrawings(), 1);
}

TEST(StillRenderer, WhatChangesInTheSceneIsSeen)
{
  Scene still(true);
  Scene drawn(false);
  EXPECT_TRUE(still.picture() == drawn.picture());
  int drawings = still.Still->GetNumberOfDrawings();
  const std::vector<std::function<void(Scene&)>> changes{
    [](Scene& s) { s.Back->GetActiveCamera()->Azimuth(30.0); },
    [](Scene& s) { s.BallActor->GetProperty()->SetColor(0.2, 0.7, 0.3); },
    [](Scene& s) { s.Ball->SetRadius(0.8); },
    [](Scene& s) { s.Back->SetBackground(0.1, 0.1, 0.2); },
    [](Scene& s) { s.Window->SetSize(width + 20, height - 30); },
    [](Scene& s) { s.BallActor->VisibilityOff(); },
  };
  for (std::size_t k = 0; k < changes.size(); ++k)
  {
    const std::vector<unsigned char> before = still.picture();
    changes[k](still);
    changes[k](drawn);
    EXPECT_FALSE(still.picture() == before) << k;
    EXPECT_TRUE(still.picture() == drawn.picture()) << k;
    EXPECT_EQ(still.Still->GetNumberOfDrawings(), ++drawings) << k;
  }
}
