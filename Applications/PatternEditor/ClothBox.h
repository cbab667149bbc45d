// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QComboBox>
#include <QGroupBox>
#include <QLineEdit>

#include <functional>
#include <string>

namespace editor
{
/// What the pieces are cut from, and how they lie on it.
class ClothBox : public QGroupBox
{
public:
  ClothBox();

  /// As vtkWireWarpingFilter has them.
  std::string material() const;
  std::string grain() const { return this->Grain->text().trimmed().toStdString(); }

  std::function<void()> onChange;
  /// Where the dialog for a file starts.
  void setFolder(const QString& folder) { this->Folder = folder; }

  QComboBox* materials() { return this->Material; }
  QLineEdit* grainField() { return this->Grain; }

private:
  QComboBox* Material;
  QLineEdit* Grain;
  QString Folder;
};
}
