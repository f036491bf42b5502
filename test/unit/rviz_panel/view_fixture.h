// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QLabel>
#include <QTest>

#include "goal_alignment/AlignResult.h"
#include "messages.h"
#include "rviz_panel/alignment_view.h"

namespace goal_alignment::rviz_panel {

constexpr int kNarrow = 350;  // pixels
constexpr int kHigh = 700;

inline AlignmentState::Ptr withoutPlan() {
  auto state = stateWith(3);
  state->phase = AlignmentState::DONE;
  state->outcome = AlignResult::EXPECTATION_UNACHIEVABLE;
  state->message = "it can't all be had.";
  state->conflict = {state->candidates[0].fluent, state->candidates[1].fluent};
  for (int i = 0; i < 2; ++i) {
    AlternativeGoal alternative;
    alternative.given_up = {state->candidates[static_cast<std::size_t>(i)].fluent};
    alternative.probability = 0.25 * (i + 1);
    state->alternatives.push_back(alternative);
  }
  return state;
}

/// The whole view without ROS.
class View : public testing::Test {
 protected:
  View() {
    view_.resize(kNarrow, kHigh);
    view_.show();
    view_.showPresence(AlignerLink::Presence::There);
    QApplication::processEvents();
  }

  template <typename Widget>
  Widget* find(const QString& name) {
    auto* widget = view_.findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name.toStdString();
    return widget;
  }

  QString textOf(const QString& name) { return find<QLabel>(name)->text(); }
  bool isShown(const QString& name) { return find<QWidget>(name)->isVisible(); }

  void click(const QString& name) { QTest::mouseClick(find<QWidget>(name), Qt::LeftButton); }

  void show(const AlignmentState::ConstPtr& state) {
    view_.showState(state);
    QApplication::processEvents();
  }

  void ask(const Question::ConstPtr& question) {
    view_.showQuestion(question);
    QApplication::processEvents();
    QApplication::processEvents();
  }

  // Into the folder that PANEL_PICTURES names, if any.
  void savePicture(const char* name) {
    const QString folder = qEnvironmentVariable("PANEL_PICTURES");
    if (!folder.isEmpty()) view_.grab().save(folder + "/" + name + ".png");
  }

  // Every visible widget with a text lies inside of the view, and its text inside of it.
  void expectAllFits(const char* picture) {
    savePicture(picture);
    for (QWidget* widget : view_.findChildren<QWidget*>()) {
      if (!widget->isVisible() || qobject_cast<QAbstractItemView*>(widget) != nullptr) continue;
      const QRect place(widget->mapTo(&view_, QPoint(0, 0)), widget->size());
      const auto* label = qobject_cast<QLabel*>(widget);
      const auto* button = qobject_cast<QAbstractButton*>(widget);
      if (label == nullptr && button == nullptr) continue;
      EXPECT_GE(place.left(), 0) << widget->objectName().toStdString();
      EXPECT_LE(place.right(), view_.width()) << widget->objectName().toStdString();
      if (label != nullptr && label->wordWrap()) {
        EXPECT_GE(label->height(), label->heightForWidth(label->width()))
            << label->text().toStdString();
      }
      if (button != nullptr && !button->text().isEmpty()) {
        QString text = button->text();
        EXPECT_GE(button->width(), button->fontMetrics().horizontalAdvance(text.remove('&')))
            << text.toStdString();
      }
    }
  }

  AlignmentView view_;
};

}  // namespace goal_alignment::rviz_panel
