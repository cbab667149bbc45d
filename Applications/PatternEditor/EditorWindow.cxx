// SPDX-License-Identifier: BSD-3-Clause
#include "EditorWindow.h"

#include "EditorFiles.h"
#include "PatternPicture.h"

#include <vtkFeatureCurveEditor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleImage.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>

#include <QCloseEvent>
#include <QFontDatabase>
#include <QMessageBox>
#include <QSplitter>
#include <QStatusBar>
#include <QVBoxLayout>

#include <stdexcept>

namespace editor
{
namespace
{
constexpr int restMilliseconds = 150;
constexpr int sideWidth = 270;
constexpr std::size_t tableRows = 6;
const char* const broken = "color: #b00000; font-weight: bold";
}

//------------------------------------------------------------------------------
EditorWindow::EditorWindow()
  : SpaceScene(this->Space)
  , PlaneScene(this->Plane)
  , SpaceWidget(this->addView(this->Space))
  , PlaneWidget(this->addView(this->Plane))
  , Panel(new CurvePanel(this->Curves))
  , Unit(new QComboBox)
  , Measures(new QLabel)
  , Message(new QLabel)
  , Hint(new QLabel)
  , Rest(new QTimer(this))
{
  auto* const views = new QSplitter(Qt::Horizontal);
  auto* const side = new QWidget;
  auto* const sideLayout = new QVBoxLayout(side);
  sideLayout->addWidget(this->Panel, 1);
  sideLayout->addWidget(new QLabel("Unit of the surface"));
  sideLayout->addWidget(this->Unit);
  side->setMaximumWidth(sideWidth);
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
  layout->addWidget(this->Measures);
  layout->addWidget(this->Message);
  this->setCentralWidget(central);
  this->statusBar()->addWidget(this->Hint, 1);
  this->Message->setWordWrap(true);
  this->Measures->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  this->Unit->addItems({ "cm", "mm", "m", "inch" });
  this->Unit->setToolTip("What a length of 1 means in the pattern.");
  this->Plane->SetBackground(1.0, 1.0, 1.0);

  this->Rest->setSingleShot(true);
  this->Rest->setInterval(restMilliseconds);
  QObject::connect(this->Rest, &QTimer::timeout, [this] { this->flattenNow(); });
  this->connectHand();
  this->makeFileMenu();
  this->makeHandActions();
  this->makeViewMenu();
  this->makeBar();
  this->resize(1500, 900);
  this->setWindowTitle("PatternEditor");
  this->Hint->setText("Open a surface: File > Open surface, Ctrl+O.");
}

//------------------------------------------------------------------------------
EditorWindow::~EditorWindow()
{
  this->Curves->RemoveAllObservers();
  this->Hand->RemoveAllObservers();
  this->Hand->SetEnabled(0);
  // The name's field ends its editing when it loses the focus, and that renames a curve: not once
  // the curves are gone.
  this->hide();
}

//------------------------------------------------------------------------------
QVTKOpenGLNativeWidget* EditorWindow::addView(vtkRenderer* renderer)
{
  auto* const view = new QVTKOpenGLNativeWidget;
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
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    view->interactor()->SetInteractorStyle(style);
  }
  return view;
}

//------------------------------------------------------------------------------
void EditorWindow::connectHand()
{
  this->Hand->SetInteractor(this->SpaceWidget->interactor());
  this->Hand->SetDefaultRenderer(this->Space);
  this->Hand->SetEditor(this->Curves);
  this->Hand->HandleKeysOff();
  this->Hand->SetEnabled(1);
  this->Curves->AddObserver(vtkCommand::ModifiedEvent, this, &EditorWindow::followCurves);
  this->Hand->AddObserver(vtkCommand::SelectionChangedEvent, this, &EditorWindow::followChoice);
  this->Hand->AddObserver(vtkCommand::CursorChangedEvent, this, &EditorWindow::followChoice);
  this->Panel->onChoose = [this](int curve) { this->Hand->Choose(curve, -1); };
  this->Panel->onRefusal = [this](const std::string& why) { this->tell(why, true); };
}

//------------------------------------------------------------------------------
template <typename Work>
bool EditorWindow::attempt(const Work& work)
{
  try
  {
    work();
    return true;
  }
  catch (const std::runtime_error& error)
  {
    this->tell(error.what(), true);
    return false;
  }
}

//------------------------------------------------------------------------------
bool EditorWindow::openSurface(const std::string& path)
{
  return this->attempt([&] {
    const figures::PolyData surface = readPolyData(path);
    if (!this->Curves->SetSurface(surface))
    {
      throw std::runtime_error(this->Curves->GetMessage());
    }
    this->Surface = surface;
    this->Name = stemOf(path);
    this->Saved = this->Curves->GetMTime();
    this->Hand->SetSurface(surface);
    this->SpaceScene.setSurface(surface);
    this->PlaneScene.clear();
    this->Live.setSurface(surface);
    this->setWindowTitle(QString::fromStdString(this->Name + " - PatternEditor"));
    this->flattenNow();
    this->followChoice();
  });
}

//------------------------------------------------------------------------------
bool EditorWindow::openCurves(const std::string& path)
{
  return this->attempt([&] {
    const figures::PolyData lines = readPolyData(path);
    if (lines->GetNumberOfLines() == 0)
    {
      throw std::runtime_error(path + " holds no lines; is it a surface?");
    }
    if (!this->Curves->SetCurves(lines))
    {
      throw std::runtime_error(this->Curves->GetMessage());
    }
    this->Saved = this->Curves->GetMTime();
    this->Hand->Choose(-1, -1);
  });
}

//------------------------------------------------------------------------------
bool EditorWindow::saveCurves(const std::string& path)
{
  return this->attempt([&] {
    vtkNew<vtkPolyData> drawn;
    this->Curves->GetCurves(drawn);
    writePolyData(path, drawn);
    this->Saved = this->Curves->GetMTime();
    this->tell("saved " + path, false);
  });
}

//------------------------------------------------------------------------------
bool EditorWindow::savePattern(const std::string& path)
{
  return this->attempt([&] {
    if (this->Rest->isActive())
    {
      this->flattenNow();
    }
    if (!this->Live.hasResult())
    {
      throw std::runtime_error("there is no flat piece yet to make a pattern of");
    }
    writePattern(path, this->Live.result(), this->Unit->currentText().toStdString(), this->Name);
    this->tell("saved " + path, false);
  });
}

//------------------------------------------------------------------------------
bool EditorWindow::savePicture(const std::string& path)
{
  return this->attempt([&] {
    if (!this->grab().save(QString::fromStdString(path)))
    {
      throw std::runtime_error("cannot write " + path);
    }
    this->tell("saved " + path, false);
  });
}

//------------------------------------------------------------------------------
void EditorWindow::followCurves()
{
  this->followChoice();
  if (!this->Surface)
  {
    return;
  }
  if (this->Live.isQuick(Care::Full))
  {
    this->flattenNow();
    return;
  }
  if (this->Live.isQuick(Care::Draft))
  {
    this->flattenNow(Care::Draft);
  }
  this->Rest->start();
}

//------------------------------------------------------------------------------
void EditorWindow::followChoice()
{
  this->Panel->show(this->Hand->GetChosenCurve());
  this->Hint->setText(this->Hand->GetHint());
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

//------------------------------------------------------------------------------
void EditorWindow::flattenNow(Care care)
{
  this->Rest->stop();
  vtkNew<vtkPolyData> curves;
  this->Curves->GetCurves(curves);
  const bool flat = this->Live.run(curves, care);
  this->tell(this->Live.message(), true);
  if (flat)
  {
    this->showResult();
  }
}

//------------------------------------------------------------------------------
void EditorWindow::showResult()
{
  if (!this->Live.hasResult())
  {
    return;
  }
  QString table;
  for (const std::string& row : figures::errorTable(this->Live.result(), tableRows))
  {
    table += QString::fromStdString(row) + "\n";
  }
  table = table.trimmed();
  if (this->Live.care() == Care::Draft)
  {
    table += "   (draft)";
  }
  this->Measures->setText(table);
  this->SpaceScene.color(this->Live.result(), this->Coloring);
  this->PlaneScene.show(this->Live.result(), this->Coloring);
  this->SpaceWidget->renderWindow()->Render();
  this->PlaneWidget->renderWindow()->Render();
}

//------------------------------------------------------------------------------
void EditorWindow::tell(const std::string& words, bool bad)
{
  this->Message->setStyleSheet(bad ? broken : "");
  this->Message->setText(QString::fromStdString(words));
}

//------------------------------------------------------------------------------
void EditorWindow::resetViews()
{
  this->SpaceScene.resetCamera();
  this->PlaneScene.reset();
  this->showResult();
}

//------------------------------------------------------------------------------
bool EditorWindow::mayForgetCurves()
{
  return this->Curves->GetNumberOfCurves() == 0 || this->Curves->GetMTime() == this->Saved ||
    QMessageBox::question(this, "PatternEditor", "The curves are not saved. Go on without them?") ==
    QMessageBox::Yes;
}

//------------------------------------------------------------------------------
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
