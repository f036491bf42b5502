// SPDX-License-Identifier: BSD-3-Clause
#include "wording.h"

#include <QtMath>

#include "goal_alignment/AlignResult.h"
#include "names.h"

namespace goal_alignment::rviz_panel {
namespace {

QString questions(unsigned number) {
  return number == 1 ? QStringLiteral("1 question") : QStringLiteral("%1 questions").arg(number);
}

QString outcomeLine(const AlignmentState& state) {
  switch (state.outcome) {
    case AlignResult::SUCCESS:
      return QStringLiteral("Plan found after %1").arg(questions(state.questions_asked));
    case AlignResult::CANCELED:
      return QStringLiteral("Canceled");
    case AlignResult::GOAL_UNSOLVABLE:
    case AlignResult::EXPECTATION_UNACHIEVABLE:
      return QStringLiteral("There is no plan, that is certain");
    case AlignResult::UNSURE_BLOCKS:
      return QStringLiteral("It depends on what you are not sure of");
    case AlignResult::DECLINED:
      return QStringLiteral("No further questions, and so no plan");
    case AlignResult::NO_ANSWER:
      return QStringLiteral("Nobody answered");
    case AlignResult::BUSY:
      return QStringLiteral("Another plan is being carried out");
    default:
      return QStringLiteral("Ended without a plan (outcome %1)").arg(state.outcome);
  }
}

// As people write names.
QString plain(const std::string& name) {
  return QString::fromStdString(name).replace('-', ' ').replace('_', ' ');
}

}  // namespace

QString pddlOf(const Fluent& fluent) {
  QString atom = "(" + QString::fromStdString(fluent.name);
  for (const std::string& arg : fluent.args)
    atom += " " + QString::fromStdString(arg);
  atom += ")";
  return fluent.negated != 0 ? "(not " + atom + ")" : atom;
}

QString phraseOf(const Fluent& fluent) {
  if (!fluent.text.empty()) return QString::fromStdString(fluent.text);
  QStringList args;
  for (const std::string& arg : fluent.args)
    args << plain(arg);
  const QString atom = plain(fluent.name) + (args.isEmpty() ? "" : ": " + args.join(", "));
  return fluent.negated != 0 ? "not so: " + atom : atom;
}

QStringList phrasesOf(const std::vector<Fluent>& fluents) {
  QStringList phrases;
  for (const Fluent& fluent : fluents)
    phrases << phraseOf(fluent);
  return phrases;
}

QString pddlOf(const ActionDispatch& step) {
  QString text = "(" + QString::fromStdString(step.name);
  for (const auto& parameter : step.parameters)
    text += " " + QString::fromStdString(parameter.value);
  return text + ")";
}

QString sentence(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString stateWord(std::uint8_t candidate_state) {
  switch (candidate_state) {
    case Candidate::SPECIFIED:
      return QStringLiteral("asked for");
    case Candidate::OPEN:
      return QStringLiteral("open");
    case Candidate::ASKED:
      return QStringLiteral("asked now");
    case Candidate::WANTED:
      return QStringLiteral("wanted");
    case Candidate::NOT_WANTED:
      return QStringLiteral("not wanted");
    case Candidate::UNSURE:
      return QStringLiteral("not sure");
    case Candidate::SETTLED:
      return QStringLiteral("settled");
    default:
      return QStringLiteral("state %1").arg(candidate_state);
  }
}

bool isAnswered(const Candidate& candidate) {
  return candidate.answered_by != kAssumed &&
         (candidate.state == Candidate::WANTED || candidate.state == Candidate::NOT_WANTED ||
          candidate.state == Candidate::UNSURE);
}

QString phaseLine(const AlignmentState& state) {
  switch (state.phase) {
    case AlignmentState::IDLE:
      return QStringLiteral("Waiting for a task");
    case AlignmentState::ANALYSING:
      return QStringLiteral("Thinking …");
    case AlignmentState::AWAITING_ANSWER:
      return QStringLiteral("Waiting for your answer");
    case AlignmentState::PLANNING:
      return QStringLiteral("Making the plan …");
    default:
      return outcomeLine(state);
  }
}

QString titleOf(const std::string& task_id, const std::string& person) {
  const QString task = sentence(QString::fromStdString(task_id).replace('_', ' '));
  const QString whose = QString::fromStdString(person);
  if (task.isEmpty() && whose.isEmpty()) return {};
  if (whose.isEmpty()) return task;
  return task.isEmpty() ? QStringLiteral("A task for %1").arg(whose)
                        : QStringLiteral("%1, for %2").arg(task, whose);
}

bool isUnderWay(const AlignmentState& state) {
  return state.phase != AlignmentState::IDLE && state.phase != AlignmentState::DONE;
}

bool endedWithoutPlan(const AlignmentState& state) {
  return state.phase == AlignmentState::DONE && state.outcome != AlignResult::SUCCESS;
}

QString percent(double probability) {
  return QStringLiteral("%1 %").arg(qRound(100 * qBound(0.0, probability, 1.0)));
}

}  // namespace goal_alignment::rviz_panel
