// SPDX-License-Identifier: BSD-3-Clause
#include "outcome_card.h"

#include <QVBoxLayout>

#include "goal_alignment/AlignResult.h"
#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kMargin = 10;       // pixels
constexpr int kMaxButtons = 170;  // pixels: more alternatives scroll
constexpr double kLarge = 1.15;

bool isProven(const AlignmentState& state) {
  return state.outcome == AlignResult::GOAL_UNSOLVABLE ||
         state.outcome == AlignResult::EXPECTATION_UNACHIEVABLE;
}

QString conflictText(const std::vector<Fluent>& conflict) {
  if (conflict.empty()) return {};
  QString text = conflict.size() == 1 ? QStringLiteral("This can't be had:")
                                      : QStringLiteral("These can't be had together:");
  for (const QString& phrase : phrasesOf(conflict))
    text += QStringLiteral("\n  •  ") + phrase;
  return text;
}

QString offerOf(const AlternativeGoal& alternative) {
  const QString what = phrasesOf(alternative.given_up).join(QStringLiteral("; "));
  return alternative.given_up.size() > 1 ? QStringLiteral("Go on without these: %1").arg(what)
                                         : QStringLiteral("Go on without this: %1").arg(what);
}

bool looksSame(const AlignmentState& a, const AlignmentState& b) {
  return a.header.stamp == b.header.stamp && a.session_id == b.session_id &&
         a.outcome == b.outcome && a.message == b.message && a.phase == b.phase;
}

}  // namespace

OutcomeCard::OutcomeCard(QWidget* parent)
    : Card(Tone::Bad, parent),
      headline_(new WrappedLabel(this)),
      message_(new WrappedLabel(this)),
      conflict_(new WrappedLabel(this)),
      scroll_(new ShortScroll(kMaxButtons, this)),
      again_(new QPushButton(QStringLiteral("Try again"), this)) {
  setObjectName(QStringLiteral("outcome_card"));
  headline_->setLook(kLarge, true);
  conflict_->setObjectName(QStringLiteral("conflict"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin - 2, kMargin, kMargin);
  for (WrappedLabel* label : {headline_, message_, conflict_})
    layout->addWidget(label);
  layout->addWidget(scroll_);
  layout->addWidget(again_);
  again_->setObjectName(QStringLiteral("try_again"));
  again_->setToolTip(
      QStringLiteral("The task once more, from how things are now; answers are kept"));
  connect(again_, &QPushButton::clicked, this,
          [this] { emit retried(QString::fromStdString(shown_.session_id)); });
  hide();
}

void OutcomeCard::show(const AlignmentState& state) {
  setVisible(endedWithoutPlan(state));
  if (isHidden() || looksSame(state, shown_)) return;
  shown_ = state;
  setTone(isProven(state)                          ? Tone::Bad
          : state.outcome == AlignResult::CANCELED ? Tone::Muted
                                                   : Tone::Warning);
  const QString headline = phaseLine(state);
  headline_->say(headline);
  const QString message = sentence(QString::fromStdString(state.message));
  // Where there is a conflict, the message says the same in one long sentence, and what would
  // decide.
  const bool says_more = (state.conflict.empty() || state.outcome == AlignResult::UNSURE_BLOCKS) &&
                         message.compare(headline, Qt::CaseInsensitive) != 0;
  message_->say(says_more ? message : QString());
  setToolTip(message);
  conflict_->say(conflictText(state.conflict));
  showAlternatives(state);
}

void OutcomeCard::showAlternatives(const AlignmentState& state) {
  scroll_->setHidden(state.alternatives.empty());
  auto* buttons = new QWidget;
  auto* layout = new QVBoxLayout(buttons);
  layout->setContentsMargins(0, 0, 0, 0);
  int number = 0;
  for (const AlternativeGoal& alternative : state.alternatives) {
    auto* button = new WrappedButton(offerOf(alternative),
                                     QStringLiteral("how likely you can do without it: %1")
                                         .arg(percent(alternative.probability)),
                                     buttons);
    button->setObjectName(QStringLiteral("alternative_%1").arg(number++));
    layout->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, id = QString::fromStdString(state.session_id), given_up = alternative.given_up] {
              emit takenUp(id, given_up);
            });
  }
  scroll_->hold(buttons);
}

}  // namespace goal_alignment::rviz_panel
