// SPDX-License-Identifier: BSD-3-Clause
#include "rviz_scenario.h"

#include <ros/package.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/this_node.h>
#include <rviz/panel.h>
#include <rviz/visualization_frame.h>
#include <rviz/yaml_config_reader.h>
#include <rviz/yaml_config_writer.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QTabWidget>
#include <QThread>
#include <cstdlib>

namespace goal_alignment::test {
namespace {

constexpr int kHigh = 840;   // pixels
constexpr int kWide = 1240;  // pixels
constexpr int kRests =
    20;  // looks at a place that has not moved, 5 ms or more from one to the next
constexpr const char* kPanelClass = "goal_alignment/AlignmentPanel";

std::string alignerOf(const std::string& robot) {
  return (robot.empty() ? "" : "/" + robot) + "/goal_alignment";
}

void xdotool(const QStringList& arguments) {
  EXPECT_EQ(QProcess::execute(QStringLiteral("xdotool"), arguments), 0)
      << arguments.join(' ').toStdString();
}

// What a publisher does at a subscriber's coming or going: the panel, which is in this process and
// hears goals as well, does not count.
ros::SubscriberStatusCallback counting(const std::shared_ptr<std::atomic<int>>& others,
                                       int change) {
  return [others, change](const ros::SingleSubscriberPublisher& subscriber) {
    if (subscriber.getSubscriberName() != ros::this_node::getName()) *others += change;
  };
}

std::string pddlOf(const Fluent& fluent) {
  std::string text = "(" + fluent.name;
  for (const std::string& arg : fluent.args)
    text += " " + arg;
  return text + ")";
}

}  // namespace

bool comesTrue(const std::function<bool()>& holds, double seconds) {
  QElapsedTimer watch;
  watch.start();
  while (!holds()) {
    if (watch.elapsed() > 1000 * seconds) return false;
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    QThread::msleep(5);
  }
  return true;
}

// What was laid out a moment ago may still move.
void clickAt(const QWidget* widget, const std::function<QPoint()>& place, int button) {
  QPoint pixel;
  int rests = 0;
  ASSERT_TRUE(comesTrue([&] {
    const QPoint now = widget->isVisible() ? widget->mapToGlobal(place()) : QPoint();
    rests = now == pixel && !now.isNull() ? rests + 1 : 0;
    pixel = now;
    return rests > kRests;
  }));
  xdotool({"mousemove", QString::number(pixel.x()), QString::number(pixel.y()), "click",
           QString::number(button)});
}

void clickOn(const QWidget* widget) {
  ASSERT_NE(widget, nullptr);
  ASSERT_TRUE(comesTrue([&] { return widget->isVisible() && widget->isEnabled(); }));
  clickAt(widget, [widget] { return widget->rect().center(); });
}

void pressKeys(const std::string& keys) {
  xdotool({"key", QString::fromStdString(keys)});
}

rviz::VisualizationFrame* RvizScenario::frame_ = nullptr;

RvizScenario::RvizScenario() : spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  spinner_.start();
}

RvizScenario::~RvizScenario() {
  if (HasFailure()) {
    savePicture("failed");
    for (const auto& [robot, aligner] : aligners_)
      std::cout << test::textOf(home_.path() + "/" + robot + "output");
  }
  spinner_.stop();
}

std::string RvizScenario::configFor(const std::vector<std::string>& aligners) const {
  rviz::Config config;
  rviz::YamlConfigReader reader;
  reader.readFile(config, QString::fromStdString(ros::package::getPath("goal_alignment") +
                                                 "/config/rviz/goal_alignment.rviz"));
  rviz::Config changed;
  changed.copy(config);
  rviz::Config panels = changed.mapMakeChild("Panels");
  panels.setType(rviz::Config::List);
  for (const std::string& aligner : aligners) {
    rviz::Config panel = panels.listAppendNew();
    panel.mapSetValue("Class", kPanelClass);
    panel.mapSetValue("Name", QString::fromStdString("Alignment " + aligner));
    panel.mapSetValue("Aligner", QString::fromStdString(aligner));
  }
  const std::string file = home_.path() + "/test.rviz";
  rviz::YamlConfigWriter writer;
  writer.writeFile(changed, QString::fromStdString(file));
  return file;
}

void RvizScenario::startRviz(const std::string& config) {
  if (frame_) {
    ASSERT_TRUE(frame_->loadDisplayConfigHelper(config, true));
  } else {
    frame_ = new rviz::VisualizationFrame;
    frame_->setApp(qApp);
    frame_->setSplashPath(QString());
    frame_->initialize(QString::fromStdString(config));
    frame_->show();
  }
  frame_->setGeometry(0, 0, kWide, kHigh);
  frame_->activateWindow();
  ASSERT_TRUE(comesTrue([this] { return panel() != nullptr && panel()->isVisible(); }));
}

void RvizScenario::startAligner(const std::string& robot) {
  std::vector<std::string> arguments = {"_journal_expiry:=0"};
  if (!robot.empty()) arguments.push_back("__ns:=/" + robot);
  aligners_[robot] =
      std::make_unique<Program>(NODE_FOLDER "/goal_alignment_node", arguments,
                                std::map<std::string, std::string>{{"ROS_HOME", home_.path()}},
                                home_.path() + "/" + robot + "output");
  const std::string name = alignerOf(robot);
  if (states_.count(robot) == 0) {
    states_[robot] = std::make_unique<Topic<AlignmentState>>(node_, name + "/state");
    listeners_[robot] = std::make_shared<std::atomic<int>>(0);
    goals_[robot] = node_.advertise<AlignActionGoal>(
        name + "/align/goal", 10, counting(listeners_[robot], 1), counting(listeners_[robot], -1));
  }
  ASSERT_TRUE(comesTrue([&] { return *listeners_[robot] > 0; }));
}

void RvizScenario::killAligner(const std::string& robot) {
  aligners_[robot]->signal(SIGKILL);
  EXPECT_NE(aligners_[robot]->exitStatus(), -1);
  aligners_.erase(robot);
  ASSERT_TRUE(comesTrue([&] { return *listeners_[robot] == 0; }));
}

void RvizScenario::send(const AlignGoal& goal, const std::string& robot) {
  static int number = 0;
  AlignActionGoal message;
  message.goal_id.id = "panel-scenario-" + std::to_string(++number);
  message.goal_id.stamp = ros::Time::now();
  message.goal = goal;
  goals_[robot].publish(message);
}

QWidget* RvizScenario::panel(int number) {
  if (!frame_) return nullptr;
  int found = 0;
  for (rviz::Panel* each : frame_->findChildren<rviz::Panel*>()) {
    if (each->getClassId() == kPanelClass && found++ == number) return each;
  }
  return nullptr;
}

bool RvizScenario::shows(const QString& name, int number) {
  const QWidget* widget = part(name, number);
  return widget != nullptr && widget->isVisible();
}

QString RvizScenario::textOf(const QString& name, int number) {
  const auto* label = part<QLabel>(name, number);
  return label == nullptr ? QString() : label->text();
}

bool RvizScenario::asks(const QString& text, int number) {
  return comesTrue([&] {
    return shows("question_card", number) && textOf("question_text", number).contains(text);
  });
}

QMenu* RvizScenario::openMenu() {
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  return menu != nullptr && menu->isVisible() ? menu : nullptr;
}

void RvizScenario::choose(const QString& text) {
  ASSERT_TRUE(comesTrue([this] { return openMenu() != nullptr; }));
  QMenu* menu = openMenu();
  for (QAction* action : menu->actions()) {
    if (!action->text().contains(text)) continue;
    ASSERT_TRUE(action->isEnabled());
    clickAt(menu, [&] { return menu->actionGeometry(action).center(); });
    ASSERT_TRUE(comesTrue([this] { return openMenu() == nullptr; }));
    return;
  }
  FAIL() << "the menu has no " << text.toStdString();
}

int RvizScenario::rowWith(const QString& table, const QString& text, int number) {
  auto* view = part<QAbstractItemView>(table, number);
  if (view == nullptr) return -1;
  for (int row = 0; row < view->model()->rowCount(); ++row) {
    const QModelIndex index = view->model()->index(row, 0);
    if (index.data(Qt::ToolTipRole).toString().contains(text)) return row;
  }
  return -1;
}

void RvizScenario::clickCell(const QString& table, int row, int column, int button, int number) {
  auto* view = part<QAbstractItemView>(table, number);
  ASSERT_NE(view, nullptr);
  ASSERT_TRUE(comesTrue([&] { return view->isVisible(); }));
  const QModelIndex index = view->model()->index(row, column);
  view->scrollTo(index);
  clickAt(
      view->viewport(), [&] { return view->visualRect(index).center(); }, button);
}

void RvizScenario::openTab(int index) {
  auto* tabs = part<QTabWidget>("tabs");
  ASSERT_NE(tabs, nullptr);
  const auto* bar = tabs->findChild<QTabBar*>();
  clickAt(bar, [&] { return bar->tabRect(index).center(); });
  ASSERT_TRUE(comesTrue([&] { return tabs->currentIndex() == index; }));
}

std::optional<AlignmentState> RvizScenario::state(const std::string& robot) {
  return states_[robot]->last();
}

int RvizScenario::candidateState(const std::string& pddl, const std::string& robot) {
  const auto now = state(robot);
  if (!now) return -1;
  for (const Candidate& candidate : now->candidates) {
    if (pddlOf(candidate.fluent) == pddl) return candidate.state;
  }
  return -1;
}

// Into the folder that PANEL_PICTURES names, if any: to look at what went wrong.
void RvizScenario::savePicture(const std::string& name) {
  const char* folder = std::getenv("PANEL_PICTURES");
  if (folder == nullptr || !frame_) return;
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  QProcess::execute("import", {"-window", "root",
                               QString::fromStdString(std::string(folder) + "/" + info->name() +
                                                      "_" + name + ".png")});
}

}  // namespace goal_alignment::test
