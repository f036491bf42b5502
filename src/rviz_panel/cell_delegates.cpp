// SPDX-License-Identifier: BSD-3-Clause
#include "cell_delegates.h"

#include <QApplication>
#include <QPainter>

#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kMargin = 4;     // pixels
constexpr int kBarHeight = 4;  // pixels

}  // namespace

void BeliefDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  QStyleOptionViewItem cell = option;
  initStyleOption(&cell, index);
  cell.text.clear();
  const QStyle* style = cell.widget != nullptr ? cell.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);

  const bool selected = (option.state & QStyle::State_Selected) != 0;
  const QRect inside = option.rect.adjusted(kMargin, 1, -kMargin, -2);
  const double probability = qBound(0.0, index.data(role_).toDouble(), 1.0);
  const QColor text = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
  painter->save();
  painter->setPen(text);
  painter->drawText(inside.adjusted(0, 0, 0, -kBarHeight), Qt::AlignRight | Qt::AlignVCenter,
                    percent(probability));
  QRect bar(inside.left(), inside.bottom() - kBarHeight + 1, inside.width(), kBarHeight);
  QColor ground = text;
  ground.setAlpha(40);
  painter->fillRect(bar, ground);
  bar.setWidth(qRound(bar.width() * probability));
  painter->fillRect(bar, selected ? text : colourOf(Tone::Accent, option.palette));
  painter->restore();
}

void ToneDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  option->palette.setColor(QPalette::Text, colourOf(look_(index), option->palette));
  option->font.setBold(bold_ && look_(index) != Tone::Plain && look_(index) != Tone::Muted);
}

}  // namespace goal_alignment::rviz_panel
