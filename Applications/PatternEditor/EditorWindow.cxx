// SPDX-License-Identifier: BSD-3-Clause
#include "EditorWindow.h"

#include "Files.h"
#include "PatternPicture.h"

#include <vtkCamera.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleImage.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QApplication>
#include <QCloseEvent>
#include <QFontDatabase>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QSplitter>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace editor
{
namespace
{
/// Turns about the up of the view and never tilts it.
class TurntableStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static TurntableStyle* New();
  vtkTypeMacro(TurntableStyle, vtkInteractorStyleTrackballCamera)

  void Rotate() override
  {
    if (!this->CurrentRenderer)
    {
      return;
    }
    constexpr double degreesPerWindow = 200.0;
    constexpr double steepest = 0.999; // cosine, from which the view is not tipped on
    const int* const size = this->CurrentRenderer->GetRenderWindow()->GetSize();
    const int* const at = this->Interactor->GetEventPosition();
    const int* const before = this->Interactor->GetLastEventPosition();
    vtkCamera* const camera = this->CurrentRenderer->GetActiveCamera();
    camera->Azimuth(-degreesPerWindow * (at[0] - before[0]) / size[0]);
    const double tip = -degreesPerWindow * (at[1] - before[1]) / size[1];
    double up[3];
    camera->GetViewUp(up);
    vtkMath::Normalize(up);
    camera->Elevation(tip);
    double along[3];
    camera->GetDirectionOfProjection(along);
    if (std::abs(vtkMath::Dot(up, along)) > steepest)
    {
      camera->Elevation(-tip);
    }
    if (this->AutoAdjustCameraClippingRange)
    {
      this->CurrentRenderer->ResetCameraClippingRange();
    }
    this->Interactor->Render();
  }
};
vtkStandardNewMacro(TurntableStyle);

constexpr int restMilliseconds = 150;
constexpr int lateMilliseconds = 100;
constexpr int keepMilliseconds = 300;
constexpr int sideWidth = 270;
constexpr int fewestRows = 3;
constexpr int messageRows = 2;
const char* const measureWords =
  "E_len: error of the lengths of boundary and curves, E_ang: of the triangles' angles, "
  "E_area: of areas, all 0 at best.\nE_h, E_r: the least and the largest change of area, of width "
  "to height, 1 at best.\nflips, overlaps: what cannot be cut so.";
const char* const broken = "color: #b00000; font-weight: bold";
}

EditorWindow::EditorWindow()
  : SpaceScene(this->Space)
  , PlaneScene(this->Plane)
  , Live(std::make_unique<LiveFlattening>(
      [this] { QCoreApplication::postEvent(this, new QEvent(QEvent::User)); }))
  , SpaceWidget(this->addView(this->Space))
  , PlaneWidget(this->addView(this->Plane))
  , Panel(new CurvePanel(this->Curves))
  , Cloth(new ClothBox)
  , Unit(new QComboBox)
  , Size(new QLabel)
  , Measures(new QLabel)
  , Message(new QLabel)
  , Hint(new QLabel)
  , Readout(new QLabel)
  , Rest(new QTimer(this))
  , Late(new QTimer(this))
  , Keep(new QTimer(this))
{
  figures::silence(this->Pattern);
  auto* const views = new QSplitter(Qt::Horizontal);
  auto* const side = new QWidget;
  auto* const sideLayout = new QVBoxLayout(side);
  sideLayout->addWidget(this->Panel, 1);
  sideLayout->addWidget(new QLabel("Unit of the surface"));
  sideLayout->addWidget(this->Unit);
  sideLayout->addWidget(this->Size);
  side->setFixedWidth(sideWidth);
  views->addWidget(this->SpaceWidget);
  views->addWidget(this->PlaneWidget);
  views->addWidget(side);
  views->setSizes({ 500, 500, 230 });
  views->setStretchFactor(0, 1);
  views->setStretchFactor(1, 1);
  views->setStretchFactor(2, 0);
  auto* const central = new QWidget;
  auto* const layout = new QVBoxLayout(central);
  layout->addWidget(views, 1);
  layout->addWidget(this->Readout);
  layout->addWidget(this->Measures);
  layout->addWidget(this->Message);
  this->setCentralWidget(central);
  this->statusBar()->addWidget(this->Hint, 1);
  this->Message->setWordWrap(true);
  this->Measures->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  // The views keep their size when a line more is said.
  this->Measures->setMinimumHeight(fewestRows * this->Measures->fontMetrics().lineSpacing());
  this->Measures->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  this->Message->setMinimumHeight(messageRows * this->Message->fontMetrics().lineSpacing());
  this->Message->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  this->Unit->addItems({ "cm", "mm", "m", "inch" });
  this->Unit->setToolTip("What a length of 1 means in the pattern.");
  QObject::connect(this->Unit, QOverload<int>::of(&QComboBox::currentIndexChanged), [this](int) {
    this->UnitStated = true;
    this->showSize();
  });
  this->Measures->setToolTip(measureWords);
  this->takePalette();

  this->Rest->setSingleShot(true);
  this->Rest->setInterval(restMilliseconds);
  QObject::connect(this->Rest, &QTimer::timeout, [this] { this->askForPieces(Care::Full); });
  this->Late->setSingleShot(true);
  this->Late->setInterval(lateMilliseconds);
  QObject::connect(this->Late, &QTimer::timeout, [this] { this->showBehind(); });
  this->Keep->setSingleShot(true);
  this->Keep->setInterval(keepMilliseconds);
  QObject::connect(this->Keep, &QTimer::timeout, [this] { this->keepUnsaved(); });
  this->makeCloth(sideLayout);
  this->connectHand();
  this->makeFileMenu();
  this->makeHandActions();
  this->makeProposalMenu(sideLayout);
  this->makeViewMenu();
  this->makeBar();
  for (const QMenu* menu : this->menuBar()->findChildren<QMenu*>())
  {
    QObject::connect(menu, &QMenu::aboutToShow, [this] { this->letGo(); });
  }
  this->resize(QSize(1500, 900).boundedTo(this->screen()->availableSize()));
  this->setWindowTitle("PatternEditor");
  this->showSize();
  this->followChoice(); // there is no surface yet, and little that can be done
  this->Hint->setText("Open a surface: File > Open surface, Ctrl+O.");
}

EditorWindow::~EditorWindow()
{
  this->Live.reset(); // its thread tells this window of what it finds
  this->Curves->RemoveAllObservers();
  this->Hand->RemoveAllObservers();
  this->Hand->SetEnabled(0);
  // The name's field ends its editing when it loses the focus, and that renames a curve: not once
  // the curves are gone.
  this->hide();
}

QVTKOpenGLStereoWidget* EditorWindow::addView(vtkRenderer* renderer)
{
  auto* const view = new QVTKOpenGLStereoWidget;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  view->setRenderWindow(window);
  window->AddRenderer(renderer);
  view->setMouseTracking(true);
  if (renderer == this->Plane)
  {
    vtkNew<vtkInteractorStyleImage> style;
    view->interactor()->SetInteractorStyle(style);
  }
  else
  {
    vtkNew<TurntableStyle> style;
    view->interactor()->SetInteractorStyle(style);
  }
  // The styles' own keys: q would end the program, w and 3 draw otherwise.
  view->interactor()->RemoveObservers(vtkCommand::CharEvent);
  return view;
}

void EditorWindow::connectHand()
{
  vtkRenderWindow* const window = this->SpaceWidget->renderWindow();
  window->SetNumberOfLayers(2);
  window->AddRenderer(this->Front);
  this->Front->SetLayer(1);
  this->Front->SetActiveCamera(this->Space->GetActiveCamera());
  this->Front->PreserveDepthBufferOn();
  this->Front->InteractiveOff(); // the style turns the surface's camera
  this->Hand->SetInteractor(this->SpaceWidget->interactor());
  this->Hand->SetDefaultRenderer(this->Space);
  this->Hand->SetCurveRenderer(this->Front);
  this->Hand->SetEditor(this->Curves);
  this->Hand->HandleKeysOff();
  this->Hand->SetEnabled(1);
  this->Curves->AddObserver(vtkCommand::ModifiedEvent, this, &EditorWindow::followCurves);
  this->Hand->AddObserver(vtkCommand::SelectionChangedEvent, this, &EditorWindow::followChoice);
  this->Hand->AddObserver(vtkCommand::CursorChangedEvent, this, &EditorWindow::followChoice);
  this->Hand->AddObserver(vtkCommand::WarningEvent, this, &EditorWindow::showRefusal);
  this->Panel->onChoose = [this](int curve) { this->Hand->Choose(curve, -1); };
  this->Panel->onRefusal = [this](const std::string& why) { this->tell(why, true); };
  this->Panel->onMirror = [this] { this->action(vtkFeatureCurveWidget::MIRROR)->trigger(); };
}

void EditorWindow::followChoice()
{
  this->Panel->show(this->Hand->GetChosenCurve());
  this->Hint->setText(this->Hand->GetHint());
  for (QAction* const action : this->SurfaceActions)
  {
    action->setEnabled(this->Surface != nullptr);
  }
  if (this->OffsetAction)
  {
    this->OffsetAction->setEnabled(this->Hand->GetChosenCurve() >= 0);
  }
  for (int id = 0; id < vtkFeatureCurveWidget::NUMBER_OF_ACTIONS; ++id)
  {
    QAction* const action = this->action(id);
    if (action)
    {
      action->setEnabled(this->Surface && this->Hand->CanDo(id));
      action->setChecked(this->Hand->IsOn(id));
    }
  }
}

void EditorWindow::showRefusal()
{
  this->tell(this->Hand->GetHint(), true);
}

void EditorWindow::showSize()
{
  this->Panel->setUnit(this->Unit->currentText());
  this->Proposed->setUnit(this->Unit->currentText());
  this->Hand->SetLengthUnit(this->Unit->currentText().toStdString());
  if (this->Surface)
  {
    const double* const bounds = this->Surface->GetBounds();
    this->Size->setText(QString("It is %1 x %2 x %3 %4.")
                          .arg(bounds[1] - bounds[0], 0, 'g', 3)
                          .arg(bounds[3] - bounds[2], 0, 'g', 3)
                          .arg(bounds[5] - bounds[4], 0, 'g', 3)
                          .arg(this->Unit->currentText()));
  }
}

void EditorWindow::tell(const std::string& words, bool bad)
{
  const QString style = bad ? broken : "";
  if (style !=
    this->Message->styleSheet()) // which is read and applied anew, at each step of a drag
  {
    this->Message->setStyleSheet(style);
  }
  this->Message->setText(QString::fromStdString(words));
}

void EditorWindow::resetViews()
{
  this->SpaceScene.resetCamera();
  this->PlaneScene.reset();
  this->showResult();
}

void EditorWindow::lookAlong(int axis)
{
  if (!this->Surface)
  {
    return;
  }
  double bounds[6];
  this->Surface->GetBounds(bounds);
  const bool yUp = bounds[3] - bounds[2] > bounds[5] - bounds[4];
  const std::array<figures::Vector, 3> upright{ { { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 },
    { 0.0, 1.0, 0.0 } } };
  const std::array<figures::Vector, 3> lying{ { { 0.0, -1.0, 0.0 }, { 1.0, 0.0, 0.0 },
    { 0.0, 0.0, 1.0 } } };
  vtkCamera* const camera = this->Space->GetActiveCamera();
  this->SpaceScene.lookFrom((yUp ? upright : lying)[static_cast<std::size_t>(axis)]);
  if (!yUp && axis != 2)
  {
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Space->ResetCamera(bounds);
  }
  this->showResult();
}

bool EditorWindow::isUnsaved() const
{
  return this->Curves->GetNumberOfCurves() > 0 && this->Curves->GetMTime() != this->Saved;
}

bool EditorWindow::mayForgetCurves()
{
  if (!this->isUnsaved())
  {
    return true;
  }
  // Return, pressed in passing, must not lose them.
  const QMessageBox::StandardButton answer =
    QMessageBox::question(this, "PatternEditor", "The curves are not saved.",
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save)
  {
    this->askSave();
    return this->Curves->GetMTime() == this->Saved;
  }
  return answer == QMessageBox::Discard;
}

void EditorWindow::letGo()
{
  for (const QVTKOpenGLStereoWidget* view : { this->SpaceWidget, this->PlaneWidget })
  {
    for (const unsigned long event : { vtkCommand::LeftButtonReleaseEvent,
           vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonReleaseEvent })
    {
      view->interactor()->InvokeEvent(event);
    }
  }
}

bool EditorWindow::event(QEvent* event)
{
  if (event->type() == QEvent::WindowBlocked)
  {
    this->letGo();
  }
  if (event->type() == QEvent::PaletteChange)
  {
    this->takePalette();
  }
  return QMainWindow::event(event);
}

void EditorWindow::takePalette()
{
  // Lines and words on it are black.
  constexpr double darkest = 0.6;
  const double light = std::max(darkest, this->palette().color(QPalette::Base).lightnessF());
  for (vtkRenderer* const renderer : { this->space(), this->plane() })
  {
    renderer->SetBackground(light, light, light);
    if (renderer->GetRenderWindow())
    {
      renderer->GetRenderWindow()->Render();
    }
  }
}

void EditorWindow::closeEvent(QCloseEvent* event)
{
  if (this->mayForgetCurves())
  {
    event->accept();
  }
  else
  {
    event->ignore();
  }
}
}
