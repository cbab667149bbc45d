// SPDX-License-Identifier: BSD-3-Clause
#include "ProposalBox.h"

#include <vtkFeatureCurveRepresentation.h>

#include <QGridLayout>
#include <QToolButton>

#include <cmath>

namespace editor
{
namespace
{
constexpr double percentOfOne = 100.0;
constexpr int wordLines = 4;

/// A closed surface has no strain before it is cut.
QString strainWords(double share)
{
  return std::isnan(share) ? QString("unknown")
                           : QString::number(percentOfOne * share, 'f', 1) + " %";
}
}

ProposalBox::ProposalBox(QMenu* menu)
  : QGroupBox("Proposals")
  , Words(new QLabel)
{
  this->Words->setWordWrap(true);
  this->Words->setMinimumHeight(wordLines * this->Words->fontMetrics().lineSpacing());
  this->Words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* const layout = new QGridLayout(this);
  layout->addWidget(this->Words, 0, 0, 1, 2);
  this->Actions = { this->addAction(menu, "Accept", "F8", &ProposalBox::acceptChosen),
    this->addAction(menu, "Reject", "F9", &ProposalBox::rejectChosen),
    this->addAction(menu, "Next", "F7", &ProposalBox::next),
    this->addAction(menu, "All", "Shift+F8", &ProposalBox::acceptAll) };
  int place = 2;
  for (QAction* action : this->Actions)
  {
    auto* const button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    layout->addWidget(button, place / 2, place % 2);
    ++place;
  }
  this->set({});
}

QAction* ProposalBox::addAction(
  QMenu* menu, const QString& name, const QString& key, void (ProposalBox::*run)())
{
  QAction* const action =
    menu->addAction(name == "All" ? "Accept all proposals" : name + " proposal");
  action->setShortcut(QKeySequence(key));
  action->setIconText(name + "  [" + key + "]");
  QObject::connect(action, &QAction::triggered, [this, run] { (this->*run)(); });
  return action;
}

void ProposalBox::set(Proposals proposals)
{
  this->Waiting = std::move(proposals);
  this->Chosen = 0;
  this->showChosen();
}

void ProposalBox::setUnit(const QString& unit)
{
  this->Unit = unit;
  this->showChosen();
}

void ProposalBox::next()
{
  this->Chosen = (this->Chosen + 1) % std::max<std::size_t>(this->Waiting.cuts.size(), 1);
  this->showChosen();
}

void ProposalBox::acceptChosen()
{
  if (this->Chosen < this->Waiting.cuts.size())
  {
    // A copy, since a change of curves may come back here.
    const Proposal proposal = this->Waiting.cuts[this->Chosen];
    if (this->onAccept(proposal))
    {
      this->forget(this->Chosen);
    }
  }
}

void ProposalBox::acceptAll()
{
  this->Chosen = 0;
  this->onAcceptAll([this] {
    for (std::size_t left = this->Waiting.cuts.size(); left > 0; --left)
    {
      this->acceptChosen();
      if (this->Waiting.cuts.size() == left) // refused
      {
        return;
      }
    }
  });
}

void ProposalBox::rejectChosen()
{
  if (this->Chosen < this->Waiting.cuts.size())
  {
    this->forget(this->Chosen);
  }
}

void ProposalBox::forget(std::size_t proposal)
{
  this->Waiting.cuts.erase(this->Waiting.cuts.begin() + static_cast<std::ptrdiff_t>(proposal));
  this->Chosen = proposal < this->Waiting.cuts.size() ? proposal : 0;
  this->showChosen();
}

void ProposalBox::showChosen()
{
  const std::vector<Proposal>& cuts = this->Waiting.cuts;
  for (QAction* action : this->Actions)
  {
    action->setEnabled(!cuts.empty());
  }
  this->setVisible(!cuts.empty());
  if (!cuts.empty())
  {
    const Proposal& cut = cuts[this->Chosen];
    this->Words->setText(QString("%1 of %2: %3 (%4), length %5\u00A0%6.\nStrain %7 becomes %8.")
                           .arg(this->Chosen + 1)
                           .arg(cuts.size())
                           .arg(QString::fromStdString(cut.name))
                           .arg(vtkFeatureCurveRepresentation::GetTypeName(cut.type))
                           .arg(cut.length, 0, 'g', 4)
                           .arg(this->Unit)
                           .arg(strainWords(cut.strainBefore), strainWords(cut.strainAfter)));
  }
  if (this->onChange)
  {
    this->onChange();
  }
}
}
