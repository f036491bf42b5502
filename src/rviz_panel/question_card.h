// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPushButton>
#include <QStringList>
#include <vector>

#include "goal_alignment/Question.h"
#include "text_widgets.h"

namespace goal_alignment::rviz_panel {

/// The open question with its reason and what may be answered. A question about several fluents has
/// a tick box for each: those ticked matter, the rest don't.
class QuestionCard : public Card {
  Q_OBJECT

 public:
  explicit QuestionCard(QWidget* parent = nullptr);

  /// question_id 0: none is open, and the card hides. With the id that is shown already, the
  /// question may have changed, for others answer parts of it: what is still asked stays ticked.
  void show(const Question& question);

  /// An answer is on its way: no second one until the question changes or it was refused.
  void setWaiting(bool waiting);
  /// False: there is nobody to answer to.
  void setAnswerable(bool answerable);

 signals:
  /// `answer` of Answer.srv; `fluents` as PDDL, empty: all of the question.
  void answered(int answer, quint32 question_id, const QStringList& fluents);

 private:
  QPushButton* addButton(QWidget* row, const QString& text, const QString& name,
                         const QString& key);
  void showTicks(const Question& question, const QStringList& ticked_before);
  QStringList ticked() const;
  void labelButtons();
  void answerYes();
  void send(int answer, const QStringList& fluents = {});

  std::uint32_t id_ = 0;
  bool waiting_ = false;
  bool answerable_ = true;
  WrappedLabel* count_;
  WrappedLabel* text_;
  WrappedLabel* why_;
  ShortScroll* scroll_;
  QWidget* buttons_;
  QWidget* end_;
  QPushButton* yes_;
  QPushButton* no_;
  QPushButton* unsure_;
  QPushButton* decline_;
  std::vector<TickBox*> boxes_;
  QStringList fluents_;
};

}  // namespace goal_alignment::rviz_panel
