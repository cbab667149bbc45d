// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Proposals.h"

#include <QAction>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>

namespace editor
{
/// The proposed cuts that wait for a yes or no, one of them chosen. What can be done is in a menu
/// and on buttons; without proposals the box is hidden.
class ProposalBox : public QGroupBox
{
public:
  explicit ProposalBox(QMenu* menu);

  void set(Proposals proposals);
  /// Of all lengths.
  void setUnit(const QString& unit);
  const std::vector<Proposal>& cuts() const { return this->Waiting.cuts; }
  std::size_t chosen() const { return this->Chosen; }

  ///@{
  /// What the menu does.
  void next();
  void acceptChosen();
  void acceptAll();
  void rejectChosen();
  ///@}

  /// Adds a curve; false where it is refused, and the proposal stays.
  std::function<bool(const Proposal&)> onAccept;
  /// Runs what accepts all of them.
  std::function<void(const std::function<void()>&)> onAcceptAll;
  /// Another one is chosen, or some are gone.
  std::function<void()> onChange;

private:
  QAction* addAction(
    QMenu* menu, const QString& name, const QString& key, void (ProposalBox::*run)());
  void forget(std::size_t proposal);
  void showChosen();

  Proposals Waiting;
  std::size_t Chosen = 0;
  QString Unit;
  QLabel* Words;
  std::vector<QAction*> Actions;
};
}
