// SPDX-License-Identifier: BSD-3-Clause
#include "alignment_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "names.h"
#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kMargin = 6;          // pixels
constexpr int kProgressHeight = 4;  // pixels
constexpr int kFull = 1000;         // of the progress bar
constexpr double kLarge = 1.2;

QString counted(const QString& title, int number) {
  return number == 0 ? title : QStringLiteral("%1 (%2)").arg(title).arg(number);
}

QString promiseOf(const Plan& plan) {
  if (plan.plan_id == 0) return {};
  QStringList lines;
  if (!plan.guaranteed.empty()) {
    lines << QStringLiteral("Guaranteed: %1.").arg(phrasesOf(plan.guaranteed).join("; "));
  }
  if (!plan.not_wanted.empty()) {
    lines << QStringLiteral("Given up: %1.").arg(phrasesOf(plan.not_wanted).join("; "));
  }
  return lines.join('\n');
}

QVBoxLayout* column(QWidget* widget, int margin, int spacing) {
  auto* layout = new QVBoxLayout(widget);
  layout->setContentsMargins(margin, margin, margin, margin);
  layout->setSpacing(spacing);
  return layout;
}

}  // namespace

AlignmentView::AlignmentView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("alignment_view"));
  auto* layout = column(this, kMargin, kMargin);
  layout->addWidget(header());
  notice_card_ = new Card(Tone::Warning, this);
  notice_ = new WrappedLabel(notice_card_);
  notice_->setObjectName(QStringLiteral("notice"));
  column(notice_card_, kMargin, 0)->addWidget(notice_);
  notice_card_->hide();
  layout->addWidget(notice_card_);
  question_card_ = new QuestionCard(this);
  layout->addWidget(question_card_);
  outcome_card_ = new OutcomeCard(this);
  layout->addWidget(outcome_card_);
  layout->addWidget(tabs(), 1);
  layout->addWidget(footer());
  connectParts();
  showHeader();
  showCards();
}

QWidget* AlignmentView::header() {
  auto* widget = new QWidget(this);
  auto* rows = column(widget, 0, 3);
  auto* top = new QHBoxLayout;
  dot_ = new QLabel(QStringLiteral("●"), widget);
  title_ = new WrappedLabel(widget);
  title_->setObjectName(QStringLiteral("title"));
  title_->setLook(kLarge, true);
  cancel_ = new QPushButton(widget);
  cancel_->setObjectName(QStringLiteral("cancel"));
  top->addWidget(dot_, 0, Qt::AlignVCenter);
  top->addWidget(title_, 1);
  top->addWidget(cancel_, 0, Qt::AlignTop);
  rows->addLayout(top);
  status_ = new WrappedLabel(widget);
  status_->setObjectName(QStringLiteral("status"));
  status_->setTone(Tone::Muted);
  rows->addWidget(status_);
  progress_ = new QProgressBar(widget);
  progress_->setObjectName(QStringLiteral("progress"));
  progress_->setRange(0, kFull);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(kProgressHeight);
  rows->addWidget(progress_);
  return widget;
}

QWidget* AlignmentView::tabs() {
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName(QStringLiteral("tabs"));
  tabs_->setUsesScrollButtons(false);
  tabs_->setElideMode(Qt::ElideRight);
  auto* page = new QWidget(tabs_);
  candidates_ = new CandidateTable(page);
  filter_ = new QLineEdit(page);
  filter_->setObjectName(QStringLiteral("filter"));
  filter_->setPlaceholderText(QStringLiteral("Filter …"));
  filter_->setClearButtonEnabled(true);
  auto* rows = column(page, 2, 2);
  rows->addWidget(filter_);
  rows->addWidget(candidates_, 1);
  tabs_->addTab(page, QString());
  answers_ = new AnswerTable(tabs_);
  tabs_->addTab(answers_, QString());
  plan_page_ = new QWidget(tabs_);
  plan_ = new PlanTable(plan_page_);
  plan_note_ = new WrappedLabel(plan_page_);
  plan_note_->setObjectName(QStringLiteral("plan_note"));
  auto* plan_rows = column(plan_page_, 2, 4);
  plan_rows->addWidget(plan_, 1);
  plan_rows->addWidget(plan_note_);
  tabs_->addTab(plan_page_, QString());
  return tabs_;
}

QWidget* AlignmentView::footer() {
  auto* widget = new QWidget(this);
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  aligner_ = new QLineEdit(QString::fromLatin1(kDefaultAligner), widget);
  aligner_->setObjectName(QStringLiteral("aligner"));
  aligner_->setToolTip(QStringLiteral(
      "Name of the aligner's node, such as goal_alignment or /robot1/goal_alignment"));
  answered_by_ = new QLineEdit(QString::fromLatin1(kDefaultAnsweredBy), widget);
  answered_by_->setObjectName(QStringLiteral("answered_by"));
  answered_by_->setToolTip(QStringLiteral("Who answers: it is kept with every answer"));
  for (QLineEdit* edit : {aligner_, answered_by_})
    edit->setMinimumWidth(1);
  row->addWidget(new QLabel(QStringLiteral("Aligner"), widget));
  row->addWidget(aligner_, 3);
  row->addWidget(new QLabel(QStringLiteral("I am"), widget));
  row->addWidget(answered_by_, 2);
  return widget;
}

void AlignmentView::connectParts() {
  connect(question_card_, &QuestionCard::answered, this, &AlignmentView::answered);
  connect(outcome_card_, &OutcomeCard::takenUp, this, &AlignmentView::takenUp);
  connect(candidates_, &CandidateTable::volunteered, this,
          [this](int answer, const QStringList& fluents) { emit answered(answer, 0, fluents); });
  connect(candidates_, &CandidateTable::revised, this, &AlignmentView::revised);
  connect(answers_, &AnswerTable::revised, this, &AlignmentView::revised);
  connect(filter_, &QLineEdit::textChanged, this,
          [this](const QString& text) { candidates_->sorter().filter(text); });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (isUnderWay(*state_)) {
      emit alignmentCanceled();
    } else {
      emit executionCanceled();
    }
  });
  connect(aligner_, &QLineEdit::editingFinished, this, [this] { emit alignerEdited(aligner()); });
  connect(answered_by_, &QLineEdit::editingFinished, this,
          [this] { emit answeredByEdited(answeredBy()); });
}

void AlignmentView::clear() {
  executing_ = false;
  execution_end_.clear();
  latest_plan_ = boost::make_shared<Plan>();
  tell({});
  showQuestion(boost::make_shared<Question>());
  showState(boost::make_shared<AlignmentState>());
}

void AlignmentView::showFault(const QString& fault) {
  tell(sentence(fault));
}

void AlignmentView::showPresence(Presence presence) {
  presence_ = presence;
  showHeader();
  showCards();
}

void AlignmentView::showState(const AlignmentState::ConstPtr& state) {
  const bool new_session = state->session_id != state_->session_id;
  state_ = state;
  candidates_->candidates().show(state);
  answers_->answers().show(*state);
  if (new_session) tabs_->setCurrentIndex(0);
  showHeader();
  showCards();
  showPlanTab();
}

void AlignmentView::showQuestion(const Question::ConstPtr& question) {
  const bool other = question->question_id != question_->question_id;
  question_ = question;
  if (other) tell({});
  showCards();
}

void AlignmentView::showPlan(const Plan::ConstPtr& plan) {
  latest_plan_ = plan;
  execution_end_.clear();
  showPlanTab();
}

// A plan of an earlier session says nothing about the present one.
void AlignmentView::showPlanTab() {
  const bool ours = latest_plan_->session_id == state_->session_id;
  PlanModel& steps = plan_->steps();
  if (!ours && !executing_) {
    steps.clear();
  } else if (ours && latest_plan_->plan_id != 0 &&
             (steps.plan().plan_id != latest_plan_->plan_id ||
              steps.plan().session_id != latest_plan_->session_id)) {
    steps.show(latest_plan_);
    tabs_->setCurrentWidget(plan_page_);
  }
  QStringList notes;
  if (!execution_end_.isEmpty()) notes << execution_end_;
  const QString promise = promiseOf(steps.plan());
  if (!promise.isEmpty()) notes << promise;
  plan_note_->say(notes.join('\n'));
  tabs_->setTabText(0, counted(QStringLiteral("Candidates"), candidates_->candidates().rowCount()));
  tabs_->setTabText(1, counted(QStringLiteral("Answers"), answers_->answers().rowCount()));
  tabs_->setTabText(2, counted(QStringLiteral("Plan"), steps.rowCount()));
}

void AlignmentView::beginExecution() {
  executing_ = true;
  execution_end_.clear();
  plan_->steps().begin();
  showHeader();
  showPlanTab();
}

void AlignmentView::showExecution(const ExecutePlanFeedback& feedback) {
  executing_ = true;
  // A plan that this one displaces ends after its goal was heard.
  execution_end_.clear();
  plan_->steps().hear(feedback);
  showHeader();
  showPlanTab();
}

void AlignmentView::endExecution(const ExecutePlanResult& result) {
  executing_ = false;
  const bool success = result.outcome == ExecutePlanResult::SUCCESS;
  plan_->steps().end(result);
  execution_end_ =
      success ? QStringLiteral("Carried out.")
              : QStringLiteral("Not carried out: %1").arg(QString::fromStdString(result.reason));
  showHeader();
  showPlanTab();
}

void AlignmentView::showReply(bool accepted, const QString& message) {
  tell(accepted ? QString() : sentence(message));
  // Once accepted, the question stays as it is until the aligner says what comes next.
  if (!accepted) question_card_->setWaiting(false);
}

void AlignmentView::tell(const QString& notice) {
  notice_->say(notice);
  notice_card_->setHidden(notice.isEmpty());
}

QString AlignmentView::statusText() const {
  if (aligner().trimmed().isEmpty()) return QStringLiteral("Say below which aligner to show");
  if (presence_ == Presence::Absent) {
    return QStringLiteral("%1 is not there. Waiting for it …").arg(aligner().trimmed());
  }
  QString text = phaseLine(*state_);
  if (executing_) {
    const int step = plan_->steps().runningStep();
    text = step < 0 ? QStringLiteral("Carrying out the plan")
                    : QStringLiteral("Carrying out step %1 of %2")
                          .arg(step + 1)
                          .arg(plan_->steps().rowCount());
  } else if (isUnderWay(*state_) && state_->questions_asked > 0) {
    text += QStringLiteral("  ·  %1 asked").arg(state_->questions_asked);
  }
  if (presence_ == Presence::Replay)
    text += QStringLiteral("\nA recording: nobody is there to answer to.");
  return text;
}

void AlignmentView::showHeader() {
  const bool there = presence_ == Presence::There;
  const QString title = titleOf(*state_);
  title_->say(title.isEmpty() ? QStringLiteral("Goal alignment") : title);
  status_->say(statusText());
  const bool busy = presence_ != Presence::Absent && isUnderWay(*state_);
  progress_->setValue(presence_ == Presence::Absent ? 0 : qRound(kFull * state_->progress));
  const Tone tone = presence_ == Presence::Absent   ? Tone::Muted
                    : presence_ == Presence::Replay ? Tone::Warning
                                                    : Tone::Good;
  QPalette colours = palette();
  colours.setColor(QPalette::WindowText, colourOf(tone, palette()));
  dot_->setPalette(colours);
  cancel_->setText(busy || !executing_ ? QStringLiteral("Cancel") : QStringLiteral("Stop"));
  cancel_->setToolTip(busy || !executing_
                          ? QStringLiteral("Cancels the task; what was answered is kept")
                          : QStringLiteral("Stops the execution of the plan"));
  cancel_->setEnabled(there && (busy || executing_));
}

// While the aligner is not there, its question can't be answered and may be out of date.
void AlignmentView::showCards() {
  const bool there = presence_ == Presence::There;
  const bool absent = presence_ == Presence::Absent;
  question_card_->show(absent ? Question() : *question_);
  question_card_->setAnswerable(there);
  outcome_card_->show(*state_);
  outcome_card_->setEnabled(there);
  candidates_->setEnabled(!absent);
  candidates_->setAnswerable(there);
  answers_->setEnabled(!absent);
  answers_->setAnswerable(there);
}

}  // namespace goal_alignment::rviz_panel
