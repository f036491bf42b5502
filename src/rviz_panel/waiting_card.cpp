// SPDX-License-Identifier: BSD-3-Clause
#include "waiting_card.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "wording.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kMargin = 10;    // pixels
constexpr int kMaxTasks = 90;  // pixels: more of them scroll

bool isSame(const WaitingTask& a, const WaitingTask& b) {
  return a.goal_id == b.goal_id && a.task_id == b.task_id && a.person == b.person;
}

}  // namespace

WaitingCard::WaitingCard(QWidget* parent)
    : Card(Tone::Muted, parent), scroll_(new ShortScroll(kMaxTasks, this)) {
  setObjectName(QStringLiteral("waiting_card"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kMargin, kMargin - 2, kMargin, kMargin);
  auto* title = new WrappedLabel(this);
  title->say(QStringLiteral("Waiting until the plan has been carried out:"));
  layout->addWidget(title);
  layout->addWidget(scroll_);
  hide();
}

void WaitingCard::show(const std::vector<WaitingTask>& tasks) {
  setVisible(!tasks.empty());
  if (std::equal(tasks.begin(), tasks.end(), shown_.begin(), shown_.end(), isSame)) return;
  shown_ = tasks;
  auto* list = new QWidget;
  auto* rows = new QVBoxLayout(list);
  rows->setContentsMargins(0, 0, 0, 0);
  int number = 0;
  for (const WaitingTask& task : tasks) {
    auto* row = new QHBoxLayout;
    auto* name = new WrappedLabel(list);
    const QString title = titleOf(task.task_id, task.person);
    name->say(title.isEmpty() ? QStringLiteral("A task") : title);
    auto* cancel = new QPushButton(QStringLiteral("Cancel"), list);
    cancel->setObjectName(QStringLiteral("withdraw_%1").arg(number++));
    row->addWidget(name, 1);
    row->addWidget(cancel, 0, Qt::AlignTop);
    rows->addLayout(row);
    connect(cancel, &QPushButton::clicked, this,
            [this, id = QString::fromStdString(task.goal_id)] { emit withdrawn(id); });
  }
  scroll_->hold(list);
}

}  // namespace goal_alignment::rviz_panel
