// SPDX-License-Identifier: BSD-3-Clause
// Cloth in the window: chosen in its box, read at the mouse.
#include "EditorSession.h"

#include <vtkCell.h>

using namespace session;

namespace
{
class EditorCloth : public PatternEditor
{
protected:
  void SetUp() override
  {
    this->PatternEditor::SetUp();
    this->wait();
  }
  void wait()
  {
    this->waitForPieces();
    QApplication::processEvents();
  }
  vtkPolyData* flat() { return this->window->planeView().shown().flat; }
  double value(const char* array, vtkIdType cell)
  {
    return this->flat()->GetCellData()->GetArray(array)->GetTuple1(cell);
  }

  void choose(const QString& material)
  {
    QComboBox* const box = this->window->cloth()->materials();
    QTest::mouseClick(box, Qt::LeftButton); // opens it
    QApplication::processEvents();
    box->hidePopup();
    const int row = box->findText(material);
    ASSERT_GE(row, 0) << material.toStdString();
    box->setCurrentIndex(row);
    emit box->activated(row);
    this->wait();
  }

  /// Moves the mouse over the middle of a flat triangle.
  void pointAt(vtkIdType cell)
  {
    // A message of more lines makes the view smaller, which VTK hears from the X server later.
    ASSERT_TRUE(QTest::qWaitFor([this] {
      QVTKOpenGLStereoWidget* const view = this->window->planeWidget();
      const int* const size = view->renderWindow()->GetSize();
      const double ratio = view->devicePixelRatioF();
      return size[0] == std::lround(ratio * view->width()) &&
        size[1] == std::lround(ratio * view->height());
    }));
    std::array<double, 3> middle{};
    vtkPoints* const corners = this->flat()->GetCell(cell)->GetPoints();
    for (vtkIdType k = 0; k < 3; ++k)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        middle[i] += corners->GetPoint(k)[i] / 3.0;
      }
    }
    this->moveInPlane(
      session::pixelOf(this->window->plane(), this->window->planeWidget(), middle.data()));
  }
  void moveInPlane(const QPoint& place)
  {
    this->send(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, this->window->planeWidget());
  }
  /// A triangle large enough to be met by whole pixels.
  vtkIdType largestCell()
  {
    vtkIdType largest = 0;
    double area = 0.0;
    for (vtkIdType cell = 0; cell < this->flat()->GetNumberOfCells(); ++cell)
    {
      const double here = this->flat()->GetCell(cell)->GetLength2();
      if (here > area)
      {
        area = here;
        largest = cell;
      }
    }
    return largest;
  }
  bool says(const QString& words) { return this->window->readout().contains(words); }
};

QString percent(double strain)
{
  return QString::asprintf("%+.2f %%", 100.0 * strain);
}
}

TEST_F(EditorCloth, TheMouseReadsTheMeasuresOfTheFlatPiece)
{
  const vtkIdType cell = this->largestCell();
  this->pointAt(cell);
  EXPECT_TRUE(
    this->says(QString::asprintf("cell %.0f of piece 0", this->value("vtkOriginalCellIds", cell))))
    << this->window->readout().toStdString();
  EXPECT_TRUE(this->says(
    QString::asprintf("homogeneity %.3f", this->value("HomogeneityOfDistortion", cell))));
  EXPECT_FALSE(this->says("warp"));
  this->moveInPlane({ 1, 1 });
  EXPECT_EQ(this->window->readout(), "");
}

TEST_F(EditorCloth, TheMouseReadsThreadsShearAndTheLockingAngle)
{
  this->choose("woven-carbon");
  ASSERT_TRUE(this->flat()->GetCellData()->HasArray("StrainWarp"));
  EXPECT_TRUE(this->window->message().contains("beyond the limits"))
    << this->window->message().toStdString();
  const vtkIdType cell = this->largestCell();
  this->pointAt(cell);
  EXPECT_TRUE(this->says("warp " + percent(this->value("StrainWarp", cell))))
    << this->window->readout().toStdString();
  EXPECT_TRUE(this->says("weft " + percent(this->value("StrainWeft", cell))));
  const double shear = this->value("ShearAngle", cell);
  EXPECT_TRUE(this->says(QString::asprintf("shear %+.1f", shear)));
  EXPECT_TRUE(this->says(QString::asprintf("threads at %.1f", 90.0 - std::abs(shear))));
  EXPECT_TRUE(this->says("limit at 40")); // 50 degrees off the right angle
  this->choose("none");
  EXPECT_FALSE(this->flat()->GetCellData()->HasArray("StrainWarp"));
  EXPECT_EQ(this->window->message(), "");
}

TEST_F(EditorCloth, AGrainThatIsNoneIsSaid)
{
  this->choose("jersey");
  QLineEdit* const grain = this->window->cloth()->grainField();
  grain->setText("hem");
  emit grain->editingFinished();
  this->wait();
  EXPECT_TRUE(this->window->message().contains("\"hem\" is not a curve of the piece"))
    << this->window->message().toStdString();
  grain->setText("45");
  emit grain->editingFinished();
  this->wait();
  EXPECT_FALSE(this->window->message().contains("\"hem\""))
    << this->window->message().toStdString();
  EXPECT_NEAR(this->window->flattening().result().number("GrainAngle"), 45.0, 1e-6);
}

TEST_F(EditorCloth, MapsOfThreadsHaveTheirScale)
{
  this->choose("twill");
  QApplication::setActiveWindow(this->window.get()); // the list's popup was it
  this->window->setFocus();                          // off the list, which takes keys itself
  QTest::keyClick(this->window.get(), Qt::Key_5);
  QApplication::processEvents();
  this->pointAt(this->largestCell());
  this->picture("cloth");
  vtkActor2DCollection* const props = this->window->plane()->GetActors2D();
  bool scale = false;
  for (int k = 0; k < props->GetNumberOfItems(); ++k)
  {
    scale = scale || props->GetItemAsObject(k)->IsA("vtkScalarBarActor");
  }
  EXPECT_TRUE(scale);
  EXPECT_NE(textsOf(this->window->plane()).find("largest stretch"), std::string::npos);
  // Without a material there is none to show.
  this->choose("none");
  EXPECT_NE(textsOf(this->window->plane()).find("homogeneity"), std::string::npos);
}
