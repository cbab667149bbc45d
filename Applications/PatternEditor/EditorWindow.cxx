// SPDX-License-Identifier: BSD-3-Clause
#include "EditorWindow.h"

#include "Files.h"
#include "PatternPicture.h"
#include "StraightCorners.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkFeatureCurveEditor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleImage.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QApplication>
#include <QCloseEvent>
#include <QFontDatabase>
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressDialog>
#include <QScreen>
#include <QSplitter>
#include <QStatusBar>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

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

// Seconds. Pieces that come later would be behind the mouse, drafts that come later no help.
constexpr double quick = 0.040;
constexpr double quickDraft = 0.5;
/// What comes sooner is not announced: it would flicker.
constexpr double soon = 0.1;
constexpr std::size_t tableRows = 6;

const char* const searching = "Looking for cuts and flattening with them";
constexpr int dialogWidth = 420;
const char* const everywhere = "everywhere alike";
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

  const auto after = [](QTimer* timer, int milliseconds, const auto& run) {
    timer->setSingleShot(true);
    timer->setInterval(milliseconds);
    QObject::connect(timer, &QTimer::timeout, run);
  };
  after(this->Rest, restMilliseconds, [this] { this->askForPieces(Care::Full); });
  after(this->Late, lateMilliseconds, [this] { this->showBehind(); });
  after(this->Keep, keepMilliseconds, [this] { this->keepUnsaved(); });
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

void EditorWindow::followCurves()
{
  this->followChoice();
  if (!this->Surface)
  {
    return;
  }
  this->tell("", false);
  this->followSaving();
  const bool atOnce = this->Live->seconds(Care::Full) < quick;
  if (atOnce || this->Live->seconds(Care::Draft) < quickDraft)
  {
    this->askForPieces(atOnce ? Care::Full : Care::Draft);
  }
  if (!atOnce)
  {
    this->Rest->start();
  }
  this->expectPieces();
}

void EditorWindow::askForPieces(Care care)
{
  this->Rest->stop();
  vtkNew<vtkPolyData> curves;
  this->Curves->GetCurves(curves);
  this->Live->ask(curves, care);
}

void EditorWindow::customEvent(QEvent*)
{
  this->takePieces();
}

void EditorWindow::takePieces()
{
  if (this->Live->take())
  {
    // What something else has said stays where there is nothing new to say.
    std::string words = this->Live->message();
    const std::string corners = words.empty() ? "" : cornersOfStraightKeys(this->Curves);
    words = corners.empty() ? words : corners;
    if (!words.empty() || this->Message->text().toStdString() == this->Broken)
    {
      this->tell(words, true);
    }
    this->Broken = words;
    this->Late->stop();
    this->Behind = this->Live->isRefused();
    this->showResult();
    if (this->Live->isBusy()) // with what was changed since
    {
      this->expectPieces();
    }
  }
}

void EditorWindow::waitForPieces()
{
  if (this->Rest->isActive())
  {
    this->askForPieces(Care::Full);
  }
  QApplication::setOverrideCursor(Qt::WaitCursor);
  while (this->Live->isBusy())
  {
    QApplication::processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
    this->takePieces();
  }
  QApplication::restoreOverrideCursor();
}

void EditorWindow::expectPieces()
{
  const double full = this->Live->seconds(Care::Full);
  const double draft = this->Live->seconds(Care::Draft);
  const double expected = full < quick || draft >= quickDraft ? full : draft;
  if (expected > soon)
  {
    this->showBehind();
  }
  else if (!this->Behind && !this->Late->isActive())
  {
    this->Late->start();
  }
}

void EditorWindow::showBehind()
{
  this->Late->stop();
  this->Behind = true;
  this->showMeasures();
  if (this->Live->hasResult() && !this->PlaneScene.isDim())
  {
    this->PlaneScene.dim(true);
    this->PlaneWidget->renderWindow()->Render();
  }
}

void EditorWindow::showMeasures()
{
  QString table;
  if (this->Live->hasResult())
  {
    for (const std::string& row : figures::errorTable(this->Live->result(), tableRows))
    {
      table += QString::fromStdString(row) + "\n";
    }
    table = table.trimmed();
    table += this->Behind && this->isWaiting() ? "   (of before; recomputing...)"
      : this->Behind                           ? "   (of before: what is there now is rejected)"
      : this->Live->care() == Care::Draft      ? "   (draft)"
                                               : "";
  }
  else if (this->Behind && this->isWaiting())
  {
    table = "flattening...";
  }
  this->Measures->setEnabled(!this->Behind); // grey
  this->Measures->setText(table);
  this->Readout->setEnabled(!this->Behind);
}

void EditorWindow::showResult()
{
  this->showMeasures();
  if (!this->Live->hasResult())
  {
    return;
  }
  const figures::Coloring coloring = this->shownColoring();
  const figures::FlatPiece piece = coloring == figures::Coloring::Strain
    ? figures::withStrain(this->Live->result())
    : this->Live->result();
  this->SpaceScene.color(piece, coloring);
  this->PlaneScene.show(piece, coloring);
  this->PlaneScene.dim(this->Behind);
  this->Reader.setPiece(this->PlaneScene.shown());
  this->SpaceWidget->renderWindow()->Render();
  this->PlaneWidget->renderWindow()->Render();
}

void EditorWindow::makeCloth(QVBoxLayout* side)
{
  side->insertWidget(1, this->Cloth);
  this->Readout->setWordWrap(true);
  this->Readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  this->Cloth->onChange = [this] { this->followCloth(); };
  this->PlaneWidget->interactor()->AddObserver(
    vtkCommand::MouseMoveEvent, this, &EditorWindow::readPlane);
}

void EditorWindow::followCloth()
{
  const bool changed = this->Live->setCloth(this->Cloth->material(), this->Cloth->grain());
  if (this->Surface && changed)
  {
    this->askForPieces(Care::Full);
    this->expectPieces();
  }
}

figures::Coloring EditorWindow::shownColoring() const
{
  const auto& threads = figures::threadColorings;
  const bool ofThreads = std::find(threads.begin(), threads.end(), this->Coloring) != threads.end();
  vtkPolyData* const flat = this->Live->result().flat;
  return ofThreads && !(flat && flat->GetCellData()->HasArray("StrainWarp"))
    ? figures::Coloring::Homogeneity
    : this->Coloring;
}

void EditorWindow::readPlane()
{
  const int* const at = this->PlaneWidget->interactor()->GetEventPosition();
  this->Readout->setText(QString::fromStdString(this->Reader.at(this->Plane, at[0], at[1])));
}

void EditorWindow::askProposals()
{
  const std::vector<std::string> arrays =
    this->Surface ? weightArrays(this->Surface) : std::vector<std::string>();
  if (arrays.empty())
  {
    this->propose();
    return;
  }
  QStringList choices{ everywhere };
  for (const std::string& name : arrays)
  {
    choices.append(QString::fromStdString(name));
  }
  bool given = false;
  const QString choice = QInputDialog::getItem(this, "Propose cuts",
    "Where distortion matters: everywhere alike, or as an array of the surface says,\n"
    "which has a weight for each triangle, 0 where it does not matter",
    choices, 0, false, &given);
  if (given)
  {
    const int row = choices.indexOf(choice);
    this->propose(row > 0 ? arrays[static_cast<std::size_t>(row - 1)] : std::string());
  }
}

void EditorWindow::propose(const std::string& weights)
{
  if (!this->Surface)
  {
    this->tell("open a surface before asking for proposals", true);
    return;
  }
  // The search does not know how many flattenings it needs.
  QProgressDialog dialog(searching, "Stop", 0, 0, this); // what is found by then stays
  dialog.setWindowModality(Qt::WindowModal);
  dialog.setMinimumDuration(0);
  dialog.setAutoReset(false);
  dialog.setMinimumWidth(dialogWidth);
  dialog.show();
  vtkNew<vtkPolyData> curves;
  this->Curves->GetCurves(curves);
  const auto goOn = [&dialog](const std::string& phase) {
    dialog.setLabelText(QString("%1\n%2").arg(searching).arg(QString::fromStdString(phase)));
    QApplication::processEvents();
    return !dialog.wasCanceled();
  };
  const auto preview = [this](vtkPolyData* lines) {
    this->SpaceScene.showGhosts(lines, lines->GetNumberOfCells());
    this->SpaceWidget->renderWindow()->Render();
  };
  Proposals proposals = editor::propose(this->Surface, curves, weights, goOn, preview);
  dialog.hide();
  std::string words = proposals.stopped ? "the search was stopped"
    : proposals.cuts.empty() && proposals.message.empty()
    ? "the surface lies flat as it is: there is nothing to propose"
    : proposals.message;
  const bool bad = proposals.cuts.empty() && !proposals.stopped && !proposals.message.empty();
  if (!proposals.cuts.empty() && !proposals.mirror.empty())
  {
    words += (words.empty() ? "" : "; ") + std::string("the surface is mirrored across ") +
      proposals.mirror;
  }
  this->Proposed->set(std::move(proposals));
  this->tell(words, bad);
}

void EditorWindow::connectProposals()
{
  this->Proposed->onAccept = [this](const Proposal& proposal) {
    this->Hand->Choose(-1, -1); // ends a curve that is being drawn, which is undone by itself
    const int curve = this->Curves->GetNumberOfCurves();
    if (!accept(proposal, this->Curves))
    {
      this->tell(this->Curves->GetMessage(), true);
      return false;
    }
    this->Hand->Choose(curve, -1);
    return true;
  };
  this->Proposed->onAcceptAll = [this](const std::function<void()>& accept) {
    this->Hand->Choose(-1, -1); // as above
    const int before = this->Curves->GetNumberOfCommands();
    accept();
    this->Curves->JoinCommandsSince(before);
    this->followChoice();
  };
  this->Proposed->onChange = [this] {
    this->SpaceScene.showGhosts(linesOf(this->Proposed->cuts()), this->Proposed->chosen());
    this->SpaceWidget->renderWindow()->Render();
  };
}

bool EditorWindow::addOffset(double distance)
{
  if (this->Hand->IsDrawing())
  {
    this->Hand->Do(vtkFeatureCurveWidget::FINISH);
  }
  const int curve = this->Curves->GetNumberOfCurves();
  const bool done = this->Curves->AddOffset(this->Hand->GetChosenCurve(), distance);
  if (done)
  {
    this->Hand->Choose(curve, -1);
  }
  else
  {
    this->tell(this->Curves->GetMessage(), true);
  }
  return done;
}

void EditorWindow::askOffset()
{
  if (this->Hand->GetChosenCurve() < 0)
  {
    this->tell("choose the curve that the offset is to follow", true);
    return;
  }
  bool given = false;
  const double length = this->Curves->GetCurveLength(this->Hand->GetChosenCurve());
  const double distance = QInputDialog::getDouble(this, "Offset",
    QString("Distance over the surface, in %1; negative: on the other side")
      .arg(this->Unit->currentText()),
    0.05 * length, -1e9, 1e9, 4, &given);
  if (given)
  {
    this->addOffset(distance);
  }
}
}
