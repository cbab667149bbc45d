// SPDX-License-Identifier: BSD-3-Clause
#include "FirstPicture.h"

#include <QCoreApplication>
#include <QObject>
#include <QTimer>
#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqOutputPort.h>
#include <pqPipelineSource.h>
#include <pqRepresentation.h>
#include <pqServerManagerModel.h>
#include <pqView.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

namespace
{
constexpr int wirePort = 1;
constexpr double wireWidth = 3.0;

/// Once ParaView has shown what it shows of a filter.
void arrange(pqDataRepresentation* shown)
{
  pqOutputPort* const port = shown->getOutputPortFromInput();
  pqView* const view = shown->getView();
  if (!port || !view || !port->getSource()->getProxy()->GetProperty("BesideSurface"))
  {
    return;
  }
  if (port->getPortNumber() == wirePort && shown->getProxy()->GetProperty("LineWidth"))
  {
    vtkSMPropertyHelper(shown->getProxy(), "LineWidth").Set(wireWidth);
    shown->getProxy()->UpdateVTKObjects();
  }
  view->resetDisplay();
  view->render();
}

void watch()
{
  pqApplicationCore* const core = pqApplicationCore::instance();
  if (!core)
  {
    return;
  }
  QObject::connect(core->getServerManagerModel(), &pqServerManagerModel::representationAdded,
    [core](pqRepresentation* added) {
      auto* const shown = qobject_cast<pqDataRepresentation*>(added);
      if (shown && !core->isLoadingState()) // a state has a camera and widths of its own
      {
        QTimer::singleShot(0, shown, [shown]() { arrange(shown); });
      }
    });
}
}

void arrangeFirstPictures()
{
  // ParaView loads plugins before its window is there.
  if (QCoreApplication* const program = QCoreApplication::instance())
  {
    QTimer::singleShot(0, program, watch);
  }
}
