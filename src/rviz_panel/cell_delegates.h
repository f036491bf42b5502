// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStyledItemDelegate>

#include "colours.h"

namespace goal_alignment::rviz_panel {

/// A probability (of the role given) as a bar with its percentage.
class BeliefDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  BeliefDelegate(int role, QObject* parent) : QStyledItemDelegate(parent), role_(role) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;

 private:
  int role_;
};

/// Text in the tone that a function finds for the cell.
class ToneDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using Look = Tone (*)(const QModelIndex& index);
  ToneDelegate(Look look, bool bold, QObject* parent)
      : QStyledItemDelegate(parent), look_(look), bold_(bold) {}

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  Look look_;
  bool bold_;
};

}  // namespace goal_alignment::rviz_panel
