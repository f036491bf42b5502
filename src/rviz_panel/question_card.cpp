// SPDX-License-Identifier: BSD-3-Clause
#include "question_card.h"

#include <QHBoxLayout>
#include <QShortcut>
#include <QVBoxLayout>

#include "goal_alignment/Answer.h"
#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kMargin = 10;     // pixels
constexpr int kMaxTicks = 180;  // pixels: a long group scrolls
constexpr double kLarge = 1.15;

QString countLine(const Question& question) {
  QString text = QStringLiteral("Question %1").arg(question.asked + 1);
  if (!question.person.empty())
    text += QStringLiteral(" for %1").arg(QString::fromStdString(question.person));
  if (question.max_remaining > 1) {
    text += QStringLiteral("  ·  up to %1 more%2")
                .arg(question.max_remaining - 1)
                .arg(question.bound_is_provisional != 0 ? QStringLiteral(" for now") : QString());
  } else if (question.max_remaining == 1 && question.bound_is_provisional == 0) {
    text += QStringLiteral("  ·  the last one");
  }
  return text;
}

QStringList literalsOf(const std::vector<Fluent>& fluents) {
  QStringList texts;
  for (const Fluent& fluent : fluents)
    texts << pddlOf(fluent);
  return texts;
}

}  // namespace

QuestionCard::QuestionCard(QWidget* parent)
    : Card(Tone::Accent, parent),
      count_(new WrappedLabel(this)),
      text_(new WrappedLabel(this)),
      why_(new WrappedLabel(this)),
      scroll_(new ShortScroll(kMaxTicks, this)),
      buttons_(new QWidget(this)),
      end_(new QWidget(this)) {
  setObjectName(QStringLiteral("question_card"));
  text_->setObjectName(QStringLiteral("question_text"));
  why_->setObjectName(QStringLiteral("question_why"));
  count_->setTone(Tone::Accent);
  text_->setLook(kLarge, true);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin - 2, kMargin, kMargin);
  layout->addWidget(count_);
  layout->addWidget(text_);
  layout->addWidget(scroll_);
  layout->addWidget(why_);
  for (QWidget* row : {buttons_, end_}) {
    layout->addWidget(row);
    (new QHBoxLayout(row))->setContentsMargins(0, 2, 0, 0);
  }
  yes_ = addButton(buttons_, QStringLiteral("&Yes"), QStringLiteral("yes"), QStringLiteral("Y"));
  no_ = addButton(buttons_, QStringLiteral("&No"), QStringLiteral("no"), QStringLiteral("N"));
  unsure_ = addButton(buttons_, QStringLiteral("&Don't know"), QStringLiteral("unsure"),
                      QStringLiteral("D"));
  decline_ = addButton(end_, QStringLiteral("No further &questions"), QStringLiteral("decline"),
                       QStringLiteral("Q"));
  connect(yes_, &QPushButton::clicked, this, &QuestionCard::answerYes);
  connect(no_, &QPushButton::clicked, this, [this] { send(Answer::Request::NO); });
  connect(unsure_, &QPushButton::clicked, this, [this] { send(Answer::Request::UNSURE); });
  connect(decline_, &QPushButton::clicked, this, [this] { send(Answer::Request::DECLINE); });
  hide();
}

// Alt and the letter work in the whole window, the bare letter while the panel has the focus.
QPushButton* QuestionCard::addButton(QWidget* row, const QString& text, const QString& name,
                                     const QString& key) {
  auto* button = new QPushButton(text, row);
  button->setObjectName(name);
  button->setToolTip(QStringLiteral("Alt+%1; or %1 while the panel has the focus").arg(key));
  button->setMinimumWidth(1);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  row->layout()->addWidget(button);
  auto* shortcut =
      new QShortcut(QKeySequence(key), parentWidget() != nullptr ? parentWidget() : this);
  shortcut->setContext(Qt::WidgetWithChildrenShortcut);
  connect(shortcut, &QShortcut::activated, button, [button] {
    if (button->isVisible()) button->click();
  });
  return button;
}

void QuestionCard::show(const Question& question) {
  const bool same = question.question_id == id_;
  id_ = question.question_id;
  setVisible(id_ != 0);
  if (id_ == 0) return;
  count_->say(countLine(question));
  text_->say(QString::fromStdString(question.text));
  why_->say(QString::fromStdString(question.why));
  if (!same) {
    showTicks(question, {});
    setWaiting(false);
  } else if (literalsOf(question.fluents) != fluents_) {
    showTicks(question, ticked());
    labelButtons();
  }
}

void QuestionCard::showTicks(const Question& question, const QStringList& ticked_before) {
  boxes_.clear();
  fluents_ = literalsOf(question.fluents);
  auto* ticks = new QWidget;
  auto* layout = new QVBoxLayout(ticks);
  layout->setContentsMargins(0, 0, 0, 0);
  const bool group = question.fluents.size() > 1;
  for (int i = 0; group && i < fluents_.size(); ++i) {
    const Fluent& fluent = question.fluents[static_cast<std::size_t>(i)];
    auto* box = new TickBox(sentence(phraseOf(fluent)), ticks);
    box->setObjectName(fluents_[i]);
    box->setToolTip(fluents_[i]);
    box->setTicked(ticked_before.contains(fluents_[i]));
    connect(box, &TickBox::toggled, this, &QuestionCard::labelButtons);
    layout->addWidget(box);
    boxes_.push_back(box);
  }
  scroll_->hold(ticks);
  scroll_->setVisible(group);
}

QStringList QuestionCard::ticked() const {
  QStringList result;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (boxes_[i]->isTicked()) result << fluents_[static_cast<int>(i)];
  }
  return result;
}

void QuestionCard::labelButtons() {
  const int number = ticked().size();
  const bool group = !boxes_.empty();
  yes_->setText(number == 0 ? QStringLiteral("&Yes")
                            : QStringLiteral("&Yes, %1 of %2").arg(number).arg(fluents_.size()));
  no_->setText(group ? QStringLiteral("&None") : QStringLiteral("&No"));
  const bool enabled = answerable_ && !waiting_;
  yes_->setEnabled(enabled && (!group || number > 0));
  no_->setEnabled(enabled);
  unsure_->setEnabled(enabled);
  decline_->setEnabled(enabled);
  for (TickBox* box : boxes_)
    box->setEnabled(enabled);
}

void QuestionCard::setWaiting(bool waiting) {
  waiting_ = waiting;
  labelButtons();
}

void QuestionCard::setAnswerable(bool answerable) {
  answerable_ = answerable;
  labelButtons();
}

void QuestionCard::answerYes() {
  if (boxes_.empty()) return send(Answer::Request::YES);
  const QStringList chosen = ticked();
  if (!chosen.isEmpty()) send(Answer::Request::YES, chosen);
}

void QuestionCard::send(int answer, const QStringList& fluents) {
  if (waiting_ || !answerable_ || id_ == 0) return;
  setWaiting(true);
  emit answered(answer, id_, fluents);
}

}  // namespace goal_alignment::rviz_panel
