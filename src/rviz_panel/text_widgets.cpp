// SPDX-License-Identifier: BSD-3-Clause
#include "text_widgets.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QVBoxLayout>

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kEdge = 4;    // pixels of colour at a card's left
constexpr int kMargin = 8;  // pixels
constexpr double kSmall = 0.9;

}  // namespace

WrappedLabel::WrappedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setMinimumWidth(1);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

// The height follows from the width, so that a hint says nothing of it.
QSize WrappedLabel::sizeHint() const {
  return {QLabel::sizeHint().width(), fontMetrics().height()};
}

QSize WrappedLabel::minimumSizeHint() const {
  return {1, fontMetrics().height()};
}

void WrappedLabel::setTone(Tone tone) {
  tone_ = tone;
  paintTone();
}

void WrappedLabel::setLook(double size, bool bold) {
  QFont look = font();
  look.setPointSizeF(look.pointSizeF() * size);
  look.setBold(bold);
  setFont(look);
}

void WrappedLabel::say(const QString& text) {
  if (text != this->text()) setText(text);
  setHidden(text.isEmpty());
}

void WrappedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  // Our own change of the palette comes by here as well.
  if (event->type() == QEvent::PaletteChange) paintTone();
}

void WrappedLabel::paintTone() {
  const QPalette around = parentWidget() != nullptr ? parentWidget()->palette() : palette();
  QPalette mine = palette();
  const QColor colour = colourOf(tone_, around);
  if (mine.color(QPalette::Active, QPalette::WindowText) == colour) return;
  mine.setColor(QPalette::Active, QPalette::WindowText, colour);
  mine.setColor(QPalette::Inactive, QPalette::WindowText, colour);
  setPalette(mine);
}

WrappedButton::WrappedButton(const QString& text, const QString& note, QWidget* parent)
    : QPushButton(parent), text_(new WrappedLabel(this)), note_(new WrappedLabel(this)) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setAccessibleName(text);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin - 2, kMargin, kMargin - 2);
  layout->setSpacing(1);
  for (WrappedLabel* label : {text_, note_}) {
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    layout->addWidget(label);
  }
  note_->setTone(Tone::Muted);
  note_->setLook(kSmall, false);
  text_->say(text);
  note_->say(note);
}

int WrappedButton::heightForWidth(int width) const {
  return layout()->totalHeightForWidth(width);
}

QSize WrappedButton::sizeHint() const {
  return {layout()->totalSizeHint().width(), fontMetrics().height()};
}

QSize WrappedButton::minimumSizeHint() const {
  return {1, fontMetrics().height()};
}

ShortScroll::ShortScroll(int most, QWidget* parent) : QScrollArea(parent), most_(most) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setAutoFillBackground(false);
}

void ShortScroll::hold(QWidget* content) {
  setWidget(content);
  content->setAutoFillBackground(false);
  updateGeometry();
}

int ShortScroll::heightForWidth(int width) const {
  if (widget() == nullptr) return 0;
  // Beside a scroll bar: once there is one, QScrollArea keeps it until all would fit beside it.
  const int beside = width - verticalScrollBar()->sizeHint().width();
  const int height = widget()->hasHeightForWidth() ? widget()->heightForWidth(beside)
                                                   : widget()->sizeHint().height();
  return qMin(most_, height);
}

QSize ShortScroll::sizeHint() const {
  return {1, fontMetrics().height()};
}

QSize ShortScroll::minimumSizeHint() const {
  return {1, fontMetrics().height()};
}

TickBox::TickBox(const QString& text, QWidget* parent)
    : QWidget(parent), box_(new QCheckBox(this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* label = new WrappedLabel(this);
  label->say(text);
  box_->setAccessibleName(text);
  layout->addWidget(box_, 0, Qt::AlignTop);
  layout->addWidget(label, 1);
  connect(box_, &QCheckBox::toggled, this, &TickBox::toggled);
}

void TickBox::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && rect().contains(event->pos())) box_->toggle();
}

Card::Card(Tone tone, QWidget* parent) : QFrame(parent), tone_(tone) {
  setContentsMargins(kEdge, 0, 0, 0);
}

void Card::setTone(Tone tone) {
  tone_ = tone;
  update();
}

void Card::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::EnabledChange) update();
}

void Card::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Tone tone = isEnabled() ? tone_ : Tone::Muted;
  painter.setPen(Qt::NoPen);
  painter.setBrush(colourOf(tone, palette()));
  painter.drawRoundedRect(rect(), kEdge, kEdge);
  painter.setBrush(tintOf(tone, palette()));
  painter.drawRoundedRect(rect().adjusted(kEdge, 1, -1, -1), kEdge - 1, kEdge - 1);
}

}  // namespace goal_alignment::rviz_panel
