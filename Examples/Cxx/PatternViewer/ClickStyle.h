// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderer.h>

#include <array>
#include <functional>
#include <string>

namespace viewer
{
/// Cameras by the mouse, where the plane is moved and not turned; clicks without a drag, and keys,
/// are handed on.
class ClickStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static ClickStyle* New();
  vtkTypeMacro(ClickStyle, vtkInteractorStyleTrackballCamera)

  vtkRenderer* plane = nullptr;
  std::function<void(int, int)> onClick;
  std::function<void(const std::string&)> onKey;

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnChar() override;

protected:
  ClickStyle() = default;
  ~ClickStyle() override = default;

private:
  ClickStyle(const ClickStyle&) = delete;
  void operator=(const ClickStyle&) = delete;

  std::array<int, 2> Pressed{ 0, 0 };
};
}
