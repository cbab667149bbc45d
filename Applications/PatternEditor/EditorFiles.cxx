// SPDX-License-Identifier: BSD-3-Clause
// What EditorWindow reads and writes.
#include "EditorWindow.h"

#include "CurveList.h"
#include "FaceSeams.h"
#include "Files.h"
#include "Formats/PatternOptionTable.h"
#include "InputError.h"
#include "PolyDataOutput.h"
#include "ReadCurves.h"
#include "ReadSurface.h"
#include "TextFile.h"
#include "Units.h"
#include "WindowWords.h"

#include <vtkFeatureCurveEditor.h>
#include <vtkFieldData.h>
#include <vtkFlatteningAlgorithm.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPatternWriter.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkWindowToImageFilter.h>

#include <QDateTime>
#include <QFileInfo>
#include <QImage>
#include <QLocale>
#include <QMessageBox>
#include <QPainter>
#include <QString>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>

namespace editor
{
namespace
{
using flattening::OptionValues;

void require(bool holds, const std::string& message)
{
  if (!holds)
  {
    throw std::runtime_error(message);
  }
}

/// Throws what the curves say of a change that they did not make.
void requireDone(bool done, vtkFeatureCurveEditor* curves)
{
  require(done, curves->GetMessage());
}

const char* const optionArray = "PatternOptions"; ///< of field data, "Property=value"

/// The curves as they are written, with the unit of the surface and the options of the pattern that
/// are not the defaults.
vtkSmartPointer<vtkPolyData> curvesIn(
  const QString& unit, vtkFeatureCurveEditor* curves, vtkPatternWriter* pattern)
{
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  curves->GetCurves(drawn);
  vtkFlatteningAlgorithm::SetLengthUnitOf(drawn, unit.toStdString());
  OptionValues values(flattening::pattern::patternOptions());
  pattern->GetOptions(values);
  vtkNew<vtkStringArray> kept;
  kept->SetName(optionArray);
  for (const flattening::Option* const option : values.options())
  {
    const std::string& property = option->property;
    if (values[property] != option->byDefault && property != "PatternName")
    {
      kept->InsertNextValue(property + '=' + textOf(*option, values[property]));
    }
  }
  drawn->GetFieldData()->AddArray(kept);
  return drawn;
}

/// Takes the options that a file of curves keeps; those of one that keeps none stay.
void takeOptions(vtkPolyData* curves, vtkPatternWriter* pattern)
{
  auto* const kept =
    vtkStringArray::SafeDownCast(curves->GetFieldData()->GetAbstractArray(optionArray));
  OptionValues values(flattening::pattern::patternOptions());
  for (vtkIdType k = 0; kept && k < kept->GetNumberOfValues(); ++k)
  {
    const std::string& entry = kept->GetValue(k);
    const std::size_t sign = std::min(entry.find('='), entry.size());
    const std::string text = entry.substr(std::min(sign + 1, entry.size()));
    const flattening::Option* const option = values.find(entry.substr(0, sign));
    double number = 0.0;
    if (!option || option->type == flattening::OptionType::List)
    {
      continue; // of another version
    }
    if (option->type == flattening::OptionType::Text)
    {
      values.set(option->property, text);
    }
    else if (option->type == flattening::OptionType::Word)
    {
      values.setWord(option->property, text);
    }
    else if (wirewarp::parseNumber(text, number) && isValid(*option, number))
    {
      values.set(option->property, number);
    }
  }
  if (kept)
  {
    pattern->SetOptions(values);
  }
}
}

template <typename Work>
bool EditorWindow::attempt(const Work& work)
{
  try
  {
    work();
    return true;
  }
  catch (const std::bad_alloc&)
  {
    this->tell(std::string("memory ran out; ") + wirewarp::wayOutOfMemory, true);
  }
  catch (const std::exception& error)
  {
    this->tell(error.what(), true);
  }
  return false;
}

void EditorWindow::tellException()
{
  this->attempt([] { throw; });
}

bool Application::notify(QObject* receiver, QEvent* event)
{
  try
  {
    return QApplication::notify(receiver, event);
  }
  catch (const std::exception&)
  {
    for (QWidget* const widget : topLevelWidgets())
    {
      if (auto* const window = dynamic_cast<EditorWindow*>(widget))
      {
        window->tellException();
      }
    }
    return false;
  }
}

bool EditorWindow::openSurface(const std::string& path)
{
  return this->attempt([&] {
    this->tell("", false);
    const wirewarp::SurfaceContents contents = wirewarp::readSurface(path);
    const figures::PolyData surface = wirewarp::polyDataOf(contents.surface);
    requireDone(this->Curves->SetSurface(surface), this->Curves);
    std::string healed = this->Curves->GetMessage();
    healed += (healed.empty() || contents.note.empty() ? "" : "; ") + contents.note;
    this->Surface = surface;
    this->Labels = contents.labels;
    this->Name = std::filesystem::path(path).stem().string();
    this->Folder = QFileInfo(QString::fromStdString(path)).absolutePath();
    this->Cloth->setFolder(this->Folder);
    this->Saved = this->Curves->GetMTime();
    this->UnitStated = false;
    this->takeUnit(contents.unit);
    this->showSize();
    this->Hand->SetSurface(surface);
    this->SpaceScene.setSurface(surface);
    this->Proposed->set({});
    this->PlaneScene.start(surface, this->Space->GetActiveCamera());
    this->Reader.setPiece({});
    this->Live->setSurface(surface);
    this->Behind = false;
    this->showMeasures();
    this->setWindowTitle(QString::fromStdString(this->Name + "[*] - PatternEditor"));
    if (contents.curves.lines.size() > 0)
    {
      this->showCurves(wirewarp::polyDataOf(contents.curves, surface->GetPoints()));
    }
    this->proposeUnit();
    this->askForPieces(Care::Full);
    this->expectPieces();
    this->followChoice();
    this->Journal.open(surface);
    if (!healed.empty())
    {
      this->tell(healed, false);
    }
    this->offerLeftover();
  });
}

bool EditorWindow::openCurves(const std::string& path)
{
  return this->attempt([&] {
    require(this->Surface, "open a surface before its curves");
    const wirewarp::CurveContents read =
      wirewarp::readCurves(path, wirewarp::dataSetOf(this->Surface));
    const vtkSmartPointer<vtkPolyData> curves = wirewarp::polyDataOf(read.curves);
    this->showCurves(curves, read.note);
    takeOptions(curves, this->Pattern);
    this->takeUnit(wirewarp::unitOf(read.curves));
  });
}

bool EditorWindow::takeSeams(wirewarp::SeamSource source)
{
  return this->attempt([&] {
    require(this->Surface, "open a surface before its seams");
    const wirewarp::DataSet seams =
      seamsOf(wirewarp::dataSetOf(this->Surface), this->Labels, source);
    require(seams.lines.size() > 0, "the faces of the surface have no edge to cut along");
    this->showCurves(wirewarp::polyDataOf(seams));
    this->Saved = 0; // no file has them
    this->followSaving();
  });
}

void EditorWindow::takeUnit(const std::string& stated)
{
  const int unit = this->Unit->findText(QString::fromStdString(stated));
  if (unit < 0)
  {
    return;
  }
  if (!this->UnitStated)
  {
    this->Unit->setCurrentIndex(unit);
    this->UnitStated = true; // also where it is the one that was there
  }
  else if (unit != this->Unit->currentIndex())
  {
    this->tell("the curves were saved in " + stated + ", the surface is in " +
        this->Unit->currentText().toStdString() + "; check the unit",
      true);
  }
}

void EditorWindow::proposeUnit()
{
  if (!this->UnitStated)
  {
    const wirewarp::LikelyUnit likely = wirewarp::likelyUnit(wirewarp::dataSetOf(this->Surface));
    this->Unit->setCurrentText(QString::fromStdString(likely.unit));
    this->UnitStated = false; // the list was not changed by the user
    const std::string before = this->message().toStdString();
    this->tell("the surface " + describe(likely) + "; if that is wrong, choose another unit" +
        (before.empty() ? "" : "; " + before),
      !before.empty());
  }
}

void EditorWindow::showCurves(vtkPolyData* lines, const std::string& note)
{
  requireDone(this->Curves->SetCurves(lines), this->Curves);
  std::string odd = this->Curves->GetMessage();
  odd += (odd.empty() || note.empty() ? "" : "; ") + note;
  this->Saved = this->Curves->GetMTime();
  this->followSaving();
  this->Hand->Choose(-1, -1);
  this->tell(odd, !odd.empty());
}

void EditorWindow::followSaving()
{
  const bool unsaved = this->isUnsaved();
  this->setWindowModified(unsaved);
  if (!unsaved)
  {
    this->Keep->stop();
    this->Journal.clear();
  }
  else if (!this->Keep->isActive()) // a drag goes on
  {
    this->Keep->start();
  }
}

void EditorWindow::keepUnsaved()
{
  this->attempt(
    [&] { this->Journal.write(curvesIn(this->Unit->currentText(), this->Curves, this->Pattern)); });
}

void EditorWindow::offerLeftover()
{
  const std::string path = this->Journal.leftover();
  if (path.empty())
  {
    return;
  }
  const QString when = QLocale().toString(
    QFileInfo(QString::fromStdString(path)).lastModified(), QLocale::ShortFormat);
  const QMessageBox::StandardButton answer = QMessageBox::question(this, "PatternEditor",
    "Curves on this surface were not saved when the program ended (" + when + "). Recover them?",
    QMessageBox::Yes | QMessageBox::Discard, QMessageBox::Yes);
  if (answer != QMessageBox::Yes)
  {
    this->Journal.clear();
    return;
  }
  this->attempt([&] {
    const wirewarp::CurveContents left =
      wirewarp::readCurves(path, wirewarp::dataSetOf(this->Surface));
    requireDone(this->Curves->SetCurves(wirewarp::polyDataOf(left.curves)), this->Curves);
    takeOptions(wirewarp::polyDataOf(left.curves), this->Pattern);
    this->tell("recovered what was not saved", false);
    this->takeUnit(wirewarp::unitOf(left.curves));
  });
}

bool EditorWindow::saveCurves(const std::string& path)
{
  return this->attempt([&] {
    figures::writePolyData(path, curvesIn(this->Unit->currentText(), this->Curves, this->Pattern));
    this->Saved = this->Curves->GetMTime();
    this->followSaving();
    this->tell("saved " + path, false);
  });
}

bool EditorWindow::savePattern(const std::string& path)
{
  return this->attempt([&] {
    this->waitForPieces();
    require(this->Live->hasResult(), "there is no flat piece yet to make a pattern of");
    require(!this->Live->isRefused(), "nothing is exported, since " + this->Live->message());
    this->Pattern->SetUnitByName(this->Unit->currentText().toStdString());
    this->Pattern->SetPatternName(this->Name.c_str());
    const figures::FlatPiece& result = this->Live->result();
    this->Pattern->SetInputData(0, result.flat);
    this->Pattern->SetInputData(1, result.wires);
    this->Pattern->SetInputData(2, result.cut);
    this->Pattern->SetFileName(path.c_str());
    if (this->Pattern->Write() != 1)
    {
      throw std::runtime_error(messageOf(this->Pattern));
    }
    this->tell(savedWords(path, this->Pattern), false);
  });
}

bool EditorWindow::savePicture(const std::string& path)
{
  return this->attempt([&] {
    QPixmap picture = this->grab();
    QPainter painter(&picture);
    // Windows of their own, which a picture of the other widgets does not have. They are drawn
    // anew, since what they show may still wait to be painted.
    for (QVTKOpenGLStereoWidget* view : { this->SpaceWidget, this->PlaneWidget })
    {
      vtkNew<vtkWindowToImageFilter> shot;
      shot->SetInput(view->renderWindow());
      shot->ReadFrontBufferOff();
      shot->Update();
      vtkImageData* const pixels = shot->GetOutput();
      const int width = pixels->GetDimensions()[0];
      const QImage image(static_cast<const uchar*>(pixels->GetScalarPointer()), width,
        pixels->GetDimensions()[1], 3 * width, QImage::Format_RGB888);
      painter.drawImage(QRect(view->mapTo(this, QPoint(0, 0)), view->size()), image.mirrored());
    }
    painter.end();
    require(picture.save(QString::fromStdString(path)), "cannot write " + path);
    this->tell("saved " + path, false);
  });
}

bool EditorWindow::saveSurface(const std::string& path)
{
  return this->attempt([&] {
    require(this->Surface, "there is no surface to save");
    vtkNew<vtkPolyData> saved;
    saved->ShallowCopy(this->Surface);
    vtkFlatteningAlgorithm::SetLengthUnitOf(saved, this->Unit->currentText().toStdString());
    figures::writePolyData(path, saved);
    this->tell("saved " + path, false);
  });
}
}
