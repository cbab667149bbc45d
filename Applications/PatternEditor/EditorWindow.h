// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvePanel.h"
#include "LiveFlattening.h"
#include "PlaneView.h"
#include "SpaceView.h"
#include "vtkFeatureCurveWidget.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkFeatureCurveEditor.h>

#include <QAction>
#include <QLabel>
#include <QMainWindow>
#include <QTimer>

#include <array>
#include <string>

namespace editor
{
/// Surface and curves on the left, the flat pieces on the right, which follow each change. All that
/// can be done is in the bar and in the menus, with its key.
class EditorWindow : public QMainWindow
{
public:
  EditorWindow();
  ~EditorWindow() override;

  ///@{
  /// Files. False where it was not possible; the message then says why.
  bool openSurface(const std::string& path);
  bool openCurves(const std::string& path);
  bool saveCurves(const std::string& path);
  bool savePattern(const std::string& path);
  bool savePicture(const std::string& path);
  ///@}

  vtkFeatureCurveEditor* curves() { return this->Curves; }
  vtkFeatureCurveWidget* hand() { return this->Hand; }
  const LiveFlattening& flattening() const { return this->Live; }
  /// Whether the flat pieces are still to follow the last change.
  bool isWaiting() const { return this->Rest->isActive(); }
  vtkRenderer* space() { return this->Space; }
  QVTKOpenGLNativeWidget* spaceWidget() { return this->SpaceWidget; }
  CurvePanel* panel() { return this->Panel; }
  QString message() const { return this->Message->text(); }
  /// The action of vtkFeatureCurveWidget::Actions.
  QAction* action(int id) { return this->HandActions[static_cast<std::size_t>(id)]; }

protected:
  void closeEvent(QCloseEvent* event) override;

private:
  QVTKOpenGLNativeWidget* addView(vtkRenderer* renderer);
  void makeBar();
  void makeHandActions();
  void makeFileMenu();
  void makeViewMenu();
  void connectHand();
  QAction* addAction(
    QMenu* menu, const QString& name, const QString& key, void (EditorWindow::*run)());

  void askSurface();
  void askCurves();
  void askSave();
  void askPattern();
  void askPicture();
  void resetViews();
  bool mayForgetCurves();

  void followCurves();
  void followChoice();
  void flattenNow(Care care = Care::Full);
  void showResult();
  void tell(const std::string& words, bool bad);
  template <typename Work>
  bool attempt(const Work& work);

  vtkNew<vtkFeatureCurveEditor> Curves;
  vtkNew<vtkFeatureCurveWidget> Hand;
  vtkNew<vtkRenderer> Space;
  vtkNew<vtkRenderer> Plane;
  SpaceView SpaceScene;
  PlaneView PlaneScene;
  LiveFlattening Live;
  figures::PolyData Surface;
  figures::Coloring Coloring = figures::Coloring::Homogeneity;
  std::string Name;
  vtkMTimeType Saved = 0; ///< of the curves when they were last on disk

  QVTKOpenGLNativeWidget* SpaceWidget;
  QVTKOpenGLNativeWidget* PlaneWidget;
  CurvePanel* Panel;
  QComboBox* Unit;
  QLabel* Measures;
  QLabel* Message;
  QLabel* Hint;
  QTimer* Rest; ///< runs while slow flattening waits for the mouse
  std::array<QAction*, vtkFeatureCurveWidget::NUMBER_OF_ACTIONS> HandActions{};
};
}
