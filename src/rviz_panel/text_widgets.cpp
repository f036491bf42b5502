// SPDX-License-Identifier: BSD-3-Clause
#include "text_widgets.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
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
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

// Qt's own hint is for a text of pleasant proportions; here the width is given.
QSize WrappedLabel::sizeHint() const {
  return {QLabel::sizeHint().width(), heightForWidth(width())};
}

QSize WrappedLabel::minimumSizeHint() const {
  return {1, heightForWidth(width())};
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
  fit();
}

void WrappedLabel::fit() {
  setMinimumHeight(text().isEmpty() ? 0 : heightForWidth(width()));
}

void WrappedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
}

void WrappedLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
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
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
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

int WrappedButton::heightFor(int width) const {
  const int inside = qMax(1, width - 2 * kMargin);
  int height = 2 * (kMargin - 2) + text_->heightForWidth(inside);
  if (!note_->text().isEmpty()) height += 1 + note_->heightForWidth(inside);
  return height;
}

QSize WrappedButton::sizeHint() const {
  return {QPushButton::sizeHint().width(), heightFor(width())};
}

QSize WrappedButton::minimumSizeHint() const {
  return {1, heightFor(width())};
}

void WrappedButton::resizeEvent(QResizeEvent* event) {
  QPushButton::resizeEvent(event);
  setFixedHeight(heightFor(width()));
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
