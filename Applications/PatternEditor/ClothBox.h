// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QComboBox>
#include <QGroupBox>
#include <QLineEdit>

#include <functional>
#include <string>
#include <vector>

namespace editor
{
/// What the pieces are cut from, and how they lie on it.
class ClothBox : public QGroupBox
{
public:
  ClothBox();

  /// As vtkWireWarpingFilter has them.
  std::string material() const;
  /// What stands between commas.
  std::vector<std::string> grain() const;

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
