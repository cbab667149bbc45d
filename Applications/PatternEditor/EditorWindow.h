// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ClothBox.h"
#include "CurveJournal.h"
#include "CurvePanel.h"
#include "FaceSeams.h"
#include "LiveFlattening.h"
#include "PlaneView.h"
#include "PointReadout.h"
#include "ProposalBox.h"
#include "SpaceView.h"
#include <vtkFeatureCurveWidget.h>
#include <vtkStillRenderer.h>

#include <QVTKOpenGLStereoWidget.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkPatternWriter.h>

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMainWindow>
#include <QTimer>
#include <QVBoxLayout>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace editor
{
/// Whatever a slot or an observer throws ends it alone, and the windows say why.
class Application : public QApplication
{
public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override;
};

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
  /// Seams along edges where the faces of the surface's file differ, replacing the curves.
  bool takeSeams(wirewarp::SeamSource source);
  bool saveCurves(const std::string& path);
  /// As pattern() says.
  bool savePattern(const std::string& path);
  bool savePicture(const std::string& path);
  bool saveSurface(const std::string& path);
  ///@}

  ///@{
  /// Looks for cuts, with a dialog that shows how far it is and can stop it; what is found waits in
  /// proposals(). Adds the curve at a distance from the chosen one.
  void propose(const std::string& weights = {});
  bool addOffset(double distance);
  ///@}

  /// Says what the exception is that is being handled.
  void tellException();

  vtkFeatureCurveEditor* curves() { return this->Curves; }
  vtkFeatureCurveWidget* hand() { return this->Hand; }
  const LiveFlattening& flattening() const { return *this->Live; }
  /// Whether the flat pieces are still to follow the last change.
  bool isWaiting() const { return this->Rest->isActive() || this->Live->isBusy(); }
  vtkRenderer* space() { return this->Space; }
  QVTKOpenGLStereoWidget* spaceWidget() { return this->SpaceWidget; }
  QVTKOpenGLStereoWidget* planeWidget() { return this->PlaneWidget; }
  vtkPolyData* surface() { return this->Surface; }
  CurvePanel* panel() { return this->Panel; }
  ProposalBox* proposals() { return this->Proposed; }
  ClothBox* cloth() { return this->Cloth; }
  /// What the flat piece under the mouse has to say.
  QString readout() const { return this->Readout->text(); }
  vtkRenderer* plane() { return this->Plane; }
  const PlaneView& planeView() const { return this->PlaneScene; }
  /// The numbers of the pieces, grey while they are of earlier curves.
  const QLabel* measures() const { return this->Measures; }
  QString message() const { return this->Message->text(); }
  QComboBox* unit() { return this->Unit; }
  /// The options of patterns; unit and name are the window's.
  vtkPatternWriter* pattern() { return this->Pattern; }
  QString size() const { return this->Size->text(); }
  /// The action of vtkFeatureCurveWidget::Actions.
  QAction* action(int id) { return this->HandActions[static_cast<std::size_t>(id)]; }

protected:
  /// A dialog takes the mouse from a drag, which would go on after it; views follow the palette.
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  /// Of the thread that flattens: there are pieces to take.
  void customEvent(QEvent* event) override;

private:
  QVTKOpenGLStereoWidget* addView(vtkRenderer* renderer);
  void takePalette();
  void makeBar();
  void makeHandActions();
  void makeFileMenu();
  void makeProposalMenu(QVBoxLayout* side);
  void makeViewMenu();
  void makeCloth(QVBoxLayout* side);
  void connectHand();
  void connectProposals();
  QAction* addAction(
    QMenu* menu, const QString& name, const QString& key, const std::function<void()>& run);

  /// Does what is chosen of all that the menus have now.
  void askCommand();
  /// Opens a file that the user chooses.
  void askOpen(
    const QString& title, const QString& kinds, bool (EditorWindow::*open)(const std::string&));
  /// A file to be written, or "": its name gets the extension of the one proposed where it has none
  /// of the kinds.
  std::string askFile(const QString& title, const QString& name, const QString& kinds);
  /// Writes a file that the user chooses. \param ending of the name that is proposed
  void askWrite(const QString& title, const QString& ending, const QString& kinds,
    bool (EditorWindow::*write)(const std::string&));
  void askSave();
  void askPatternOptions();
  void askProposals();
  void askOffset();
  /// As if the mouse's buttons were released.
  void letGo();
  void resetViews();
  /// From the front, the side (0, 1), or above (2). Up is of y and z the axis along which the
  /// surface is larger, as in patterns.
  void lookAlong(int axis);
  /// Whether there are curves that no file has.
  bool isUnsaved() const;
  bool mayForgetCurves();
  /// Shows in the title whether the curves are saved, and keeps those that are not in the journal.
  void followSaving();
  void keepUnsaved();
  /// Offers the curves that a window on this surface left which ended without closing.
  void offerLeftover();
  /// \param note what was left out of them
  void showCurves(vtkPolyData* lines, const std::string& note = {});
  /// Takes the unit that a file states, "" for none, unless the user or the surface has stated one.
  void takeUnit(const std::string& stated);
  /// Takes and shows the likely unit where none is stated.
  void proposeUnit();

  void followCurves();
  void followChoice();
  void showRefusal();
  void askForPieces(Care care);
  void takePieces();
  /// The pieces shown are not of the curves any more; that is said unless the new ones come soon.
  void expectPieces();
  void showBehind();
  void showMeasures();
  /// Goes on with all but what the user does until the pieces have followed.
  void waitForPieces();
  void showResult();
  /// How large the surface is in the unit chosen: who sees it knows whether that is the unit.
  void showSize();
  void followCloth();
  void readPlane();
  figures::Coloring shownColoring() const;
  void tell(const std::string& words, bool bad);
  template <typename Work>
  bool attempt(const Work& work);

  vtkNew<vtkFeatureCurveEditor> Curves;
  vtkNew<vtkFeatureCurveWidget> Hand;
  vtkNew<vtkStillRenderer> Space;
  vtkNew<vtkRenderer> Front; ///< what moves over the surface
  vtkNew<vtkRenderer> Plane;
  SpaceView SpaceScene;
  PlaneView PlaneScene;
  vtkNew<vtkPatternWriter> Pattern;
  std::unique_ptr<LiveFlattening> Live;
  CurveJournal Journal;
  figures::PolyData Surface;
  wirewarp::FaceLabels Labels; ///< what its file tells of its faces
  figures::Coloring Coloring = figures::Coloring::Homogeneity;
  std::string Name;
  QString Folder;          ///< where the next dialog for a file starts: that of the last file
  std::string Broken;      ///< the last words of the flattening
  bool Behind = false;     ///< the pieces and numbers shown are of earlier curves
  bool UnitStated = false; ///< by the user or a file; else it is what was there
  vtkMTimeType Saved = 0;  ///< of the curves when they were last on disk

  QVTKOpenGLStereoWidget* SpaceWidget;
  QVTKOpenGLStereoWidget* PlaneWidget;
  CurvePanel* Panel;
  ClothBox* Cloth;
  PointReadout Reader;
  ProposalBox* Proposed = nullptr;
  QComboBox* Unit;
  QLabel* Size;
  QLabel* Measures;
  QLabel* Message;
  QLabel* Hint;
  QLabel* Readout;
  QTimer* Rest; ///< runs while careful flattening waits for the mouse to rest
  QTimer* Late; ///< runs while pieces that may still come soon are waited for
  QTimer* Keep; ///< runs while the journal lacks what was changed last
  std::array<QAction*, vtkFeatureCurveWidget::NUMBER_OF_ACTIONS> HandActions{};
  std::vector<QAction*> SurfaceActions; ///< need a surface
  std::vector<QAction*> BarActions;     ///< of the File menu, at the bar's end
  QAction* OffsetAction = nullptr;      ///< needs a chosen curve
};
}
