// SPDX-License-Identifier: BSD-3-Clause
#include "alignment_view.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "goal_alignment/AlignResult.h"
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
  waiting_card_ = new WaitingCard(this);
  layout->addWidget(waiting_card_);
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
  plan_page_ = new PlanPage(tabs_);
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
  connect(outcome_card_, &OutcomeCard::retried, this, &AlignmentView::retried);
  connect(waiting_card_, &WaitingCard::withdrawn, this, &AlignmentView::withdrawn);
  connect(plan_page_, &PlanPage::executionWanted, this, &AlignmentView::executionWanted);
  connect(plan_page_, &PlanPage::retried, this, &AlignmentView::retried);
  connect(plan_page_, &PlanPage::newPlanShown, this,
          [this] { tabs_->setCurrentWidget(plan_page_); });
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
  plan_page_->clear();
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
  plan_page_->showSession(state->session_id, isUnderWay(*state));
  showHeader();
  showCards();
  showTabs();
}

void AlignmentView::showQuestion(const Question::ConstPtr& question) {
  const bool other = question->question_id != question_->question_id;
  question_ = question;
  if (other) tell({});
  showCards();
}

void AlignmentView::showPlan(const Plan::ConstPtr& plan) {
  plan_page_->showPlan(plan);
  showHeader();
  showTabs();
}

void AlignmentView::showTabs() {
  tabs_->setTabText(0, counted(QStringLiteral("Wishes"), candidates_->candidates().rowCount()));
  tabs_->setTabText(1, counted(QStringLiteral("Answers"), answers_->answers().rowCount()));
  tabs_->setTabText(2, counted(QStringLiteral("Plan"), plan_page_->stepCount()));
}

void AlignmentView::beginExecution() {
  plan_page_->beginExecution();
  showHeader();
  showTabs();
}

void AlignmentView::showExecution(const ExecutePlanFeedback& feedback) {
  plan_page_->showExecution(feedback);
  showHeader();
  showTabs();
}

void AlignmentView::endExecution(const ExecutePlanResult& result) {
  plan_page_->endExecution(result);
  showHeader();
  showTabs();
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
  // Once there is a plan it matters what becomes of it.
  const QString run = plan_page_->headline();
  const bool found =
      state_->phase == AlignmentState::DONE && state_->outcome == AlignResult::SUCCESS;
  if (!run.isEmpty() && (found || plan_page_->isExecuting())) {
    text = run;
  } else if (isUnderWay(*state_) && state_->questions_asked > 0) {
    text += QStringLiteral("  ·  %1 asked").arg(state_->questions_asked);
  }
  if (presence_ == Presence::Replay)
    text += QStringLiteral("\nA recording: nobody is there to answer to.");
  return text;
}

void AlignmentView::showHeader() {
  const bool there = presence_ == Presence::There;
  const QString title = titleOf(state_->task_id, state_->person);
  const bool executing = plan_page_->isExecuting();
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
  cancel_->setText(busy || !executing ? QStringLiteral("Cancel") : QStringLiteral("Stop"));
  cancel_->setToolTip(busy || !executing
                          ? QStringLiteral("Cancels the task; what was answered is kept")
                          : QStringLiteral("Stops the execution of the plan"));
  cancel_->setEnabled(there && (busy || executing));
}

// While the aligner is not there, its question can't be answered and may be out of date.
void AlignmentView::showCards() {
  const bool there = presence_ == Presence::There;
  const bool absent = presence_ == Presence::Absent;
  question_card_->show(absent ? Question() : *question_);
  question_card_->setAnswerable(there);
  outcome_card_->show(*state_);
  outcome_card_->setEnabled(there);
  waiting_card_->show(absent ? std::vector<WaitingTask>() : state_->waiting);
  waiting_card_->setEnabled(there);
  plan_page_->setAnswerable(there);
  candidates_->setEnabled(!absent);
  candidates_->setAnswerable(there);
  answers_->setEnabled(!absent);
  answers_->setAnswerable(there);
}

}  // namespace goal_alignment::rviz_panel
