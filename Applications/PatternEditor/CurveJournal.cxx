// SPDX-License-Identifier: BSD-3-Clause
#include "CurveJournal.h"

#include "Files.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <QByteArray>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <utility>

namespace editor
{
namespace
{
constexpr int mostWindows = 20; ///< on one surface

/// A name for points and triangles.
QString nameOf(vtkPolyData* surface)
{
  QCryptographicHash hash(QCryptographicHash::Sha1);
  for (vtkIdType k = 0; k < surface->GetNumberOfPoints(); ++k)
  {
    hash.addData(QByteArray::fromRawData(
      reinterpret_cast<const char*>(surface->GetPoint(k)), 3 * sizeof(double)));
  }
  vtkCellArray* const polygons = surface->GetPolys();
  for (vtkIdType k = 0; k < polygons->GetNumberOfCells(); ++k)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCellAtId(k, count, ids);
    hash.addData(QByteArray::fromRawData(reinterpret_cast<const char*>(ids),
      static_cast<int>(static_cast<std::size_t>(count) * sizeof(vtkIdType))));
  }
  return hash.result().toHex();
}
}

void CurveJournal::open(vtkPolyData* surface)
{
  this->close();
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
    "/patterneditor/unsaved";
  if (!QDir().mkpath(folder))
  {
    return;
  }
  const QString name = folder + "/" + nameOf(surface);
  for (int k = 0; k < mostWindows; ++k)
  {
    const QString path = name + "-" + QString::number(k) + ".vtp";
    auto lock = std::make_unique<QLockFile>(path + ".lock");
    lock->setStaleLockTime(0); // stale where its process has ended, however long that has worked
    if (!lock->tryLock(0))
    {
      continue; // of another window
    }
    const bool left = QFile::exists(path);
    if (left || !this->Lock)
    {
      this->Path = path;
      this->Lock = std::move(lock);
    }
    if (left)
    {
      return;
    }
  }
}

std::string CurveJournal::leftover() const
{
  return QFileInfo(this->Path).size() > 0 ? this->Path.toStdString() : std::string();
}

void CurveJournal::write(vtkPolyData* curves) const
{
  if (!this->Path.isEmpty())
  {
    figures::writePolyData(this->Path.toStdString(), curves);
  }
}

void CurveJournal::clear() const
{
  if (!this->Path.isEmpty())
  {
    QFile::remove(this->Path);
  }
}

void CurveJournal::close()
{
  this->clear();
  this->Path.clear();
  this->Lock.reset();
}
}
