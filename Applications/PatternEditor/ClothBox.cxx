// SPDX-License-Identifier: BSD-3-Clause
#include "ClothBox.h"

#include <vtkNew.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkWireWarpingFilter.h>

#include <QFileDialog>
#include <QVBoxLayout>

namespace editor
{
namespace
{
const char* const fileEntry = "from a file...";
}

ClothBox::ClothBox()
  : QGroupBox("Cloth")
  , Material(new QComboBox)
  , Grain(new QLineEdit)
{
  vtkNew<vtkTable> known;
  vtkWireWarpingFilter::ListMaterials(known);
  this->Material->addItem("none", QString());
  for (vtkIdType row = 0; row < known->GetNumberOfRows(); ++row)
  {
    const QString name = QString::fromStdString(known->GetValueByName(row, "Name").ToString());
    this->Material->addItem(name, name);
    const std::string words = known->GetValueByName(row, "Description").ToString();
    this->Material->setItemData(
      this->Material->count() - 1, QString::fromStdString(words), Qt::ToolTipRole);
  }
  this->Material->addItem(fileEntry);
  this->Material->setToolTip("What the pieces are cut from.");
  this->Grain->setPlaceholderText("grain: degrees, curves or free");
  this->Grain->setToolTip("Degrees from the upright of the piece to the warp; the name of a curve "
                          "along which it runs, or NAME:DEGREES, several separated by "
                          "commas; or free, where the cloth is strained least.");
  auto* const layout = new QVBoxLayout(this);
  layout->addWidget(this->Material);
  layout->addWidget(this->Grain);
  const auto tell = [this] {
    if (this->onChange)
    {
      this->onChange();
    }
  };
  QObject::connect(this->Grain, &QLineEdit::editingFinished, tell);
  QObject::connect(this->Material, QOverload<int>::of(&QComboBox::activated), [this, tell](int at) {
    if (this->Material->itemText(at) == fileEntry)
    {
      const QString file =
        QFileDialog::getOpenFileName(this, "Open material", this->Folder, "Materials (*.json)");
      this->Material->setItemData(at, file);
    }
    tell();
  });
}

std::string ClothBox::material() const
{
  return this->Material->currentData().toString().toStdString();
}

std::vector<std::string> ClothBox::grain() const
{
  std::vector<std::string> all;
  for (const QString& entry : this->Grain->text().split(',', Qt::SkipEmptyParts))
  {
    if (!entry.trimmed().isEmpty())
    {
      all.push_back(entry.trimmed().toStdString());
    }
  }
  return all;
}
}
