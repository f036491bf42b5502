// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/panel.h>

#include "aligner_link.h"
#include "alignment_view.h"

namespace goal_alignment::rviz_panel {

/// The panel goal_alignment/AlignmentPanel of rviz: a view of the aligner that its configuration
/// names.
class AlignmentPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit AlignmentPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;
  QSize sizeHint() const override;

 private:
  void connectParts();
  void connectTo(const QString& aligner);

  AlignerLink* link_;
  AlignmentView* view_;
  QString aligner_;
  QString answered_by_;
};

}  // namespace goal_alignment::rviz_panel
