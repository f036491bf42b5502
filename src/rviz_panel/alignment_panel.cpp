// SPDX-License-Identifier: BSD-3-Clause
#include "alignment_panel.h"

#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

#include "names.h"

namespace goal_alignment::rviz_panel {
namespace {

// Keys in the configuration of rviz.
const char* const kAlignerKey = "Aligner";
const char* const kAnsweredByKey = "Answered By";

constexpr int kUsualWidth = 400;   // pixels
constexpr int kUsualHeight = 640;  // pixels

}  // namespace

AlignmentPanel::AlignmentPanel(QWidget* parent)
    : rviz::Panel(parent),
      link_(new AlignerLink(this)),
      view_(new AlignmentView(this)),
      aligner_(QString::fromLatin1(kDefaultAligner)),
      answered_by_(QString::fromLatin1(kDefaultAnsweredBy)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  connectParts();
}

void AlignmentPanel::connectParts() {
  connect(link_, &AlignerLink::cleared, view_, &AlignmentView::clear);
  connect(link_, &AlignerLink::failed, view_, &AlignmentView::showFault);
  connect(link_, &AlignerLink::presenceChanged, view_, &AlignmentView::showPresence);
  connect(link_, &AlignerLink::stateHeard, view_, &AlignmentView::showState);
  connect(link_, &AlignerLink::questionHeard, view_, &AlignmentView::showQuestion);
  connect(link_, &AlignerLink::planHeard, view_, &AlignmentView::showPlan);
  connect(link_, &AlignerLink::executionBegun, view_, &AlignmentView::beginExecution);
  connect(link_, &AlignerLink::executionHeard, view_, &AlignmentView::showExecution);
  connect(link_, &AlignerLink::executionEnded, view_, &AlignmentView::endExecution);
  connect(link_, &AlignerLink::replied, view_, &AlignmentView::showReply);
  connect(view_, &AlignmentView::answered, link_,
          [this](int answer, quint32 question_id, const QStringList& fluents) {
            link_->answer(answer, question_id, fluents, answered_by_);
          });
  connect(view_, &AlignmentView::revised, link_, [this](int answer, const QStringList& fluents) {
    link_->revise(answer, fluents, answered_by_);
  });
  connect(view_, &AlignmentView::takenUp, link_,
          [this](const QString& session_id, const std::vector<Fluent>& given_up) {
            link_->takeUp(session_id, given_up, answered_by_);
          });
  connect(view_, &AlignmentView::retried, link_,
          [this](const QString& session_id) { link_->tryAgain(session_id, answered_by_); });
  connect(view_, &AlignmentView::executionWanted, link_, &AlignerLink::execute);
  connect(view_, &AlignmentView::withdrawn, link_, &AlignerLink::withdraw);
  connect(view_, &AlignmentView::alignmentCanceled, link_, &AlignerLink::cancelAlignment);
  connect(view_, &AlignmentView::executionCanceled, link_, &AlignerLink::cancelExecution);
  connect(view_, &AlignmentView::alignerEdited, this, [this](const QString& name) {
    if (name == aligner_) return;
    connectTo(name);
    emit configChanged();
  });
  connect(view_, &AlignmentView::answeredByEdited, this, [this](const QString& name) {
    if (name == answered_by_) return;
    answered_by_ = name;
    emit configChanged();
  });
}

void AlignmentPanel::connectTo(const QString& aligner) {
  aligner_ = aligner;
  const QString fault = link_->connectTo(aligner);
  if (!fault.isEmpty()) view_->showFault(fault);
}

// load() comes before or after it, or not at all for a panel that was just added.
void AlignmentPanel::onInitialize() {
  connectTo(aligner_);
}

void AlignmentPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  config.mapGetString(kAnsweredByKey, &answered_by_);
  view_->setAnsweredBy(answered_by_);
  QString aligner;
  if (!config.mapGetString(kAlignerKey, &aligner)) return;
  view_->setAligner(aligner);
  if (aligner != aligner_) connectTo(aligner);
}

void AlignmentPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue(kAlignerKey, aligner_);
  config.mapSetValue(kAnsweredByKey, answered_by_);
}

QSize AlignmentPanel::sizeHint() const {
  return {kUsualWidth, kUsualHeight};
}

}  // namespace goal_alignment::rviz_panel

PLUGINLIB_EXPORT_CLASS(goal_alignment::rviz_panel::AlignmentPanel, rviz::Panel)
