// SPDX-License-Identifier: BSD-3-Clause
// EditorTimes SURFACE CURVES: processor time of PatternEditor while a node is dragged,
// part by part. Run by hand.
#include "EditorWindow.h"

#include <QVTKOpenGLWindow.h>
#include <vtkMath.h>
#include <vtkRenderWindow.h>

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <sys/resource.h>
#include <vector>

namespace
{
/// Of the thread of the window, or of all: OpenGL without a graphics card draws by several.
double processorMilliseconds(int who)
{
  rusage used{};
  getrusage(who, &used);
  return 1e3 * static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
    1e-3 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

double wallMilliseconds()
{
  return std::chrono::duration<double, std::milli>(
    std::chrono::steady_clock::now().time_since_epoch())
    .count();
}

void report(const char* what, const std::function<void(int)>& work, int count = 20)
{
  std::vector<double> times;
  std::vector<double> all;
  std::vector<double> walls;
  for (int k = 0; k < count; ++k)
  {
    const double start = processorMilliseconds(RUSAGE_THREAD);
    const double startOfAll = processorMilliseconds(RUSAGE_SELF);
    const double wall = wallMilliseconds();
    work(k);
    times.push_back(processorMilliseconds(RUSAGE_THREAD) - start);
    all.push_back(processorMilliseconds(RUSAGE_SELF) - startOfAll);
    walls.push_back(wallMilliseconds() - wall);
  }
  std::sort(times.begin(), times.end());
  std::sort(all.begin(), all.end());
  std::sort(walls.begin(), walls.end());
  std::printf("%-40s median, greatest: window's thread %7.2f, %7.2f ms; all threads %7.2f, %7.2f "
              "ms; wall %7.2f, %7.2f ms\n",
    what, times[times.size() / 2], times.back(), all[all.size() / 2], all.back(),
    walls[walls.size() / 2], walls.back());
}
}

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::fprintf(stderr, "usage: EditorTimes SURFACE CURVES\n");
    return 1;
  }
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLStereoWidget::defaultFormat());
  const QApplication application(argc, argv);
  editor::EditorWindow window;
  window.resize(1400, 900);
  window.show();
  if (!window.openSurface(argv[1]) || !window.openCurves(argv[2]))
  {
    std::fprintf(stderr, "%s\n", window.message().toStdString().c_str());
    return 1;
  }
  QApplication::processEvents();
  vtkFeatureCurveEditor* const curves = window.curves();
  const int curve = 0;
  const int node = curves->GetNumberOfNodes(curve) / 2;
  double from[3];
  curves->GetNode(curve, node, from);
  double step[3];
  curves->GetNode(curve, 0, step);
  vtkMath::Subtract(step, from, step);
  const auto move = [&](int k) {
    double place[3];
    for (int i = 0; i < 3; ++i)
    {
      place[i] = from[i] + 0.002 * (k % 5 + 1) * step[i];
    }
    curves->MoveNode(curve, node, place);
  };
  vtkRenderer* const renderer = window.space();
  renderer->SetWorldPoint(from[0], from[1], from[2], 1.0);
  renderer->WorldToDisplay();
  const QPoint pixel(static_cast<int>(renderer->GetDisplayPoint()[0]),
    window.spaceWidget()->height() - 1 - static_cast<int>(renderer->GetDisplayPoint()[1]));
  const auto send = [&](QEvent::Type type, const QPoint& place, Qt::MouseButtons buttons) {
    QMouseEvent event(type, place, window.spaceWidget()->mapToGlobal(place),
      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, Qt::NoModifier);
    QApplication::sendEvent(window.spaceWidget()->embeddedOpenGLWindow(), &event);
  };
  report("the scene alone is drawn", [&](int) { window.spaceWidget()->renderWindow()->Render(); });
  report("the window's other half is drawn",
    [&](int) { window.planeWidget()->renderWindow()->Render(); });
  send(QEvent::MouseMove, pixel, Qt::NoButton);
  report("the mouse moves beside a drag",
    [&](int k) { send(QEvent::MouseMove, pixel + QPoint(20 + k % 3, 20), Qt::NoButton); });
  window.hand()->Choose(curve, node);
  curves->BeginGroup();
  report("a node moves, with all that follows", move);
  curves->EndGroup();
  send(QEvent::MouseButtonPress, pixel, Qt::LeftButton);
  const auto drag = [&](int k) {
    send(QEvent::MouseMove, pixel + QPoint(5 + k % 5, 0), Qt::LeftButton);
  };
  report("a drag goes on", drag);
  int shown = 0;
  QVTKOpenGLWindow* const view = window.spaceWidget()->embeddedOpenGLWindow();
  QObject::connect(view, &QOpenGLWindow::frameSwapped, [&shown] { ++shown; });
  const auto waitForPicture = [&shown] {
    for (const int before = shown; shown == before;)
    {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    QApplication::processEvents();
  };
  report("a drag goes on, with all that Qt paints", [&](int k) {
    drag(k);
    waitForPicture();
  });
  report("Qt paints the window", [&](int) {
    view->update();
    waitForPicture();
  });
  send(QEvent::MouseButtonRelease, pixel, Qt::NoButton);
  vtkNew<vtkFeatureCurveEditor> alone;
  alone->SetSurface(window.surface());
  vtkNew<vtkPolyData> lines;
  curves->GetCurves(lines);
  alone->SetCurves(lines);
  report("the editor's part of a move", [&](int k) {
    double place[3];
    for (int i = 0; i < 3; ++i)
    {
      place[i] = from[i] + 0.002 * (k % 5 + 1) * step[i];
    }
    alone->MoveNode(curve, node, place);
  });
  report("curves are drawn", [&](int) { window.hand()->Redraw(); });
  editor::LiveFlattening live;
  live.setSurface(window.surface());
  const auto flatten = [&](editor::Care care) {
    return [&, care](int k) {
      double place[3];
      for (int i = 0; i < 3; ++i)
      {
        place[i] = from[i] + 0.002 * (k % 5 + 1) * step[i];
      }
      alone->MoveNode(curve, node, place);
      vtkNew<vtkPolyData> moved;
      alone->GetCurves(moved);
      live.run(moved, care);
    };
  };
  report("a flat piece, isometric", flatten(editor::Care::Full), 4);
  report("a flat piece, draft", flatten(editor::Care::Draft), 4);
  return 0;
}
