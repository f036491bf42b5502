// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <QAbstractItemView>
#include <QLabel>
#include <QMenu>
#include <QString>
#include <QWidget>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/AlignActionGoal.h"
#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Question.h"
#include "program.h"

namespace rviz {
class VisualizationFrame;
}

namespace goal_alignment::test {

/// Holds within half a minute, while the windows live on. Everything takes far less.
bool comesTrue(const std::function<bool()>& holds, double seconds = 30);

/// The X server clicks there, as a mouse would, once that place has come to rest on the screen.
void clickAt(const QWidget* widget, const std::function<QPoint()>& place, int button = 1);
void clickOn(const QWidget* widget);
void pressKeys(const std::string& keys);  // as xdotool names them

/// rviz itself on the display at hand, with panels of the plugin in its docks.
class RvizScenario : public testing::Test {
 protected:
  RvizScenario();
  ~RvizScenario() override;

  /// Fails the test where the panel does not come.
  void startRviz(const std::string& config);
  /// The configuration that this package ships, with panels for these aligners.
  std::string configFor(const std::vector<std::string>& aligners) const;

  void startAligner(const std::string& robot = "");
  void killAligner(const std::string& robot = "");
  void send(const AlignGoal& goal, const std::string& robot = "");

  QWidget* panel(int number = 0);
  template <typename Widget = QWidget>
  Widget* part(const QString& name, int number = 0) {
    QWidget* within = panel(number);
    return within == nullptr ? nullptr : within->findChild<Widget*>(name);
  }
  bool shows(const QString& name, int number = 0);
  QString textOf(const QString& name, int number = 0);
  bool asks(const QString& text, int number = 0);
  QMenu* openMenu();
  void choose(const QString& action);
  void openTab(int index);
  /// The row of a table whose PDDL tool tip has the text; -1: none.
  int rowWith(const QString& table, const QString& text, int number = 0);
  void clickCell(const QString& table, int row, int column, int button = 1, int number = 0);

  std::optional<AlignmentState> state(const std::string& robot = "");
  /// The state of a candidate, -1 where there is none.
  int candidateState(const std::string& pddl, const std::string& robot = "");

  void savePicture(const std::string& name);

  ros::CallbackQueue queue_;  // rviz spins the global one in its own thread
  ros::NodeHandle node_;
  ros::AsyncSpinner spinner_;
  TemporaryFolder home_;
  std::map<std::string, std::unique_ptr<Program>> aligners_;
  std::map<std::string, std::unique_ptr<Topic<AlignmentState>>> states_;
  std::map<std::string, ros::Publisher> goals_;
  std::map<std::string, std::shared_ptr<std::atomic<int>>> listeners_;  // to goals: the aligners

 private:
  // Of all scenarios, since its graphics can't be started twice. Each loads its own panels.
  static rviz::VisualizationFrame* frame_;
};

}  // namespace goal_alignment::test
