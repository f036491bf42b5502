// SPDX-License-Identifier: BSD-3-Clause
#include "tables.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>

#include "cell_delegates.h"
#include "goal_alignment/Answer.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kRowPadding = 8;      // pixels
constexpr int kColumnPadding = 16;  // pixels
constexpr int kPhraseLength = 40;   // letters that mostly suffice

struct Choice {
  int answer;
  const char* asked;    // of what nobody has answered yet
  const char* revised;  // of what has an answer
};

constexpr Choice kChoices[] = {
    {Answer::Request::YES, "It matters to me", "Change to: yes, it matters"},
    {Answer::Request::NO, "It doesn't matter", "Change to: no, it doesn't matter"},
    {Answer::Request::UNSURE, "I don't know", "Change to: I don't know"}};

int widthOf(const QWidget& widget, const QString& text) {
  return widget.fontMetrics().horizontalAdvance(text) + kColumnPadding;
}

QMenu* newMenu(const QString& name, QWidget* parent) {
  auto* menu = new QMenu(parent);
  menu->setObjectName(name);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  return menu;
}

Tone candidateTone(const QModelIndex& index) {
  return toneOf(static_cast<std::uint8_t>(index.data(CandidateModel::StateRole).toInt()));
}

Tone answerTone(const QModelIndex& index) {
  return toneOf(static_cast<std::uint8_t>(index.data(AnswerModel::StateRole).toInt()));
}

Tone linkTone(const QModelIndex& /*index*/) {
  return Tone::Accent;
}

Tone stepTone(const QModelIndex& index) {
  switch (static_cast<PlanModel::Progress>(index.data(PlanModel::ProgressRole).toInt())) {
    case PlanModel::Progress::Running:
      return Tone::Accent;
    case PlanModel::Progress::Done:
      return index.column() == PlanModel::Mark ? Tone::Good : Tone::Muted;
    case PlanModel::Progress::Failed:
      return Tone::Bad;
    default:
      return index.column() == PlanModel::Mark ? Tone::Muted : Tone::Plain;
  }
}

}  // namespace

RowTable::RowTable(const QString& placeholder, QWidget* parent)
    : QTableView(parent), placeholder_(placeholder) {
  setSelectionBehavior(SelectRows);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(NoEditTriggers);
  setShowGrid(false);
  setWordWrap(false);
  setTabKeyNavigation(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(ScrollPerPixel);
  setFrameShape(QFrame::NoFrame);
  setMinimumSize(1, 2 * (fontMetrics().height() + kRowPadding));
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowPadding);
  horizontalHeader()->setMinimumSectionSize(1);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void RowTable::setPlaceholder(const QString& placeholder) {
  placeholder_ = placeholder;
  viewport()->update();
}

void RowTable::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  if (model() != nullptr && model()->rowCount() > 0) return;
  QPainter painter(viewport());
  painter.setPen(colourOf(Tone::Muted, palette()));
  painter.drawText(viewport()->rect().adjusted(kRowPadding, kRowPadding, -kRowPadding, 0),
                   Qt::AlignHCenter | Qt::TextWordWrap, placeholder_);
}

CandidateTable::CandidateTable(QWidget* parent)
    : RowTable(QStringLiteral("Nothing to show"), parent) {
  setObjectName(QStringLiteral("candidates"));
  sorter_.setSourceModel(&candidates_);
  setModel(&sorter_);
  setSortingEnabled(true);
  setWordWrap(true);
  sortByColumn(CandidateModel::State, Qt::AscendingOrder);
  setItemDelegateForColumn(CandidateModel::Belief,
                           new BeliefDelegate(CandidateModel::BeliefRole, this));
  setItemDelegateForColumn(CandidateModel::State, new ToneDelegate(&candidateTone, true, this));
  QHeaderView* header = horizontalHeader();
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(CandidateModel::Phrase, QHeaderView::Stretch);
  header->resizeSection(CandidateModel::Belief, widthOf(*this, QStringLiteral("Chance")) + 4);
  QFont bold = font();
  bold.setBold(true);
  header->resizeSection(
      CandidateModel::State,
      QFontMetrics(bold).horizontalAdvance(QStringLiteral("not wanted")) + kColumnPadding);
}

// A narrow table breaks its phrases into two lines.
void CandidateTable::resizeEvent(QResizeEvent* event) {
  RowTable::resizeEvent(event);
  const int needed = fontMetrics().averageCharWidth() * kPhraseLength;
  const int lines = horizontalHeader()->sectionSize(CandidateModel::Phrase) < needed ? 2 : 1;
  verticalHeader()->setDefaultSectionSize(lines * fontMetrics().height() + kRowPadding);
}

void CandidateTable::contextMenuEvent(QContextMenuEvent* event) {
  QStringList asked;
  QStringList answered;
  QStringList all;
  for (const QModelIndex& index : selectionModel()->selectedRows()) {
    const QString pddl = index.data(CandidateModel::PddlRole).toString();
    all << pddl;
    if (!index.data(CandidateModel::AnswerableRole).toBool()) continue;
    (index.data(CandidateModel::AnsweredRole).toBool() ? answered : asked) << pddl;
  }
  if (all.isEmpty()) return;
  QMenu* menu = newMenu(QStringLiteral("candidate_menu"), this);
  addAnswers(*menu, asked, false);
  if (!asked.isEmpty() && !answered.isEmpty()) menu->addSeparator();
  addAnswers(*menu, answered, true);
  if (!menu->isEmpty()) menu->addSeparator();
  menu->addAction(QStringLiteral("Copy as PDDL"), this,
                  [all] { QApplication::clipboard()->setText(all.join('\n')); });
  menu->popup(event->globalPos());
}

void CandidateTable::addAnswers(QMenu& menu, const QStringList& fluents, bool answered) {
  if (fluents.isEmpty()) return;
  for (const Choice& choice : kChoices) {
    QAction* action = menu.addAction(answered ? choice.revised : choice.asked);
    action->setEnabled(answerable_);
    connect(action, &QAction::triggered, this, [this, choice, fluents, answered] {
      if (answered) {
        emit revised(choice.answer, fluents);
      } else {
        emit volunteered(choice.answer, fluents);
      }
    });
  }
}

AnswerTable::AnswerTable(QWidget* parent) : RowTable(QStringLiteral("No answers yet"), parent) {
  setObjectName(QStringLiteral("answers"));
  setModel(&answers_);
  setItemDelegateForColumn(AnswerModel::Answer, new ToneDelegate(&answerTone, true, this));
  setItemDelegateForColumn(AnswerModel::Change, new ToneDelegate(&linkTone, false, this));
  QHeaderView* header = horizontalHeader();
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(AnswerModel::Phrase, QHeaderView::Stretch);
  header->resizeSection(AnswerModel::Answer, widthOf(*this, QStringLiteral("Don't know ")));
  header->resizeSection(AnswerModel::Change, widthOf(*this, QStringLiteral("change")));
  connect(this, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() == AnswerModel::Change) offerChange(index);
  });
  connect(this, &QTableView::doubleClicked, this, &AnswerTable::offerChange);
}

void AnswerTable::offerChange(const QModelIndex& index) {
  const QString fluent = index.data(AnswerModel::PddlRole).toString();
  QMenu* menu = newMenu(QStringLiteral("change_menu"), this);
  for (const Choice& choice : kChoices) {
    QAction* action = menu->addAction(choice.revised);
    action->setEnabled(answerable_);
    connect(action, &QAction::triggered, this,
            [this, choice, fluent] { emit revised(choice.answer, {fluent}); });
  }
  const QRect cell = visualRect(index);
  menu->popup(viewport()->mapToGlobal(cell.bottomLeft()));
}

PlanTable::PlanTable(QWidget* parent) : RowTable(QStringLiteral("No plan yet"), parent) {
  setObjectName(QStringLiteral("plan"));
  setModel(&steps_);
  setItemDelegate(new ToneDelegate(&stepTone, true, this));
  QHeaderView* header = horizontalHeader();
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(PlanModel::Text, QHeaderView::Stretch);
  header->resizeSection(PlanModel::Mark, widthOf(*this, QStringLiteral("888")));
  connect(&steps_, &PlanModel::modelReset, this, [this] {
    if (steps_.firstRow() > 0) scrollTo(steps_.index(steps_.firstRow(), 0));
    setPlaceholder(steps_.plan().plan_id > 0 ? QStringLiteral("Nothing to do: all is so already")
                                             : QStringLiteral("No plan yet"));
  });
  connect(&steps_, &PlanModel::dataChanged, this, [this] {
    if (steps_.runningStep() >= 0)
      scrollTo(steps_.index(steps_.firstRow() + steps_.runningStep(), 0));
  });
}

}  // namespace goal_alignment::rviz_panel
