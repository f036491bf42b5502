// SPDX-License-Identifier: BSD-3-Clause
// Sends a task from a YAML file, tells what happens to it, takes up the likeliest alternative where
// there is no plan, and has the plan executed; or, with ~interactive, asks the person before the
// terminal all questions, and for the alternative. Exit status 0: a plan was carried out.
#include <actionlib/client/simple_action_client.h>
#include <ros/ros.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "demo_narrator.h"
#include "goal_alignment/AlignAction.h"
#include "goal_alignment/ExecutePlanAction.h"
#include "goal_alignment/aligner/phrases_file.h"
#include "goal_alignment/dialogues/console_dialogue.h"
#include "goal_alignment/dialogues/vocabulary_file.h"
#include "goal_alignment/execution/names.h"
#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/utf8_log.h"
#include "task_file.h"

namespace {

using namespace goal_alignment;  // NOLINT(google-build-using-namespace): a main of one file
using dialogues::ConsoleDialogue;
using dialogues::PromptedTerminal;
using nodes::DemoNarrator;

constexpr double kServerPatience = 60;  // seconds until the other nodes must be there
constexpr double kStoryPatience = 10;   // seconds until what belongs to a result must be heard
constexpr double kPollPeriod = 0.02;    // seconds

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/) {
  interrupted = 1;
}

bool goesOn() {
  return ros::ok() && interrupted == 0;
}

template <typename IsThere>
void waitFor(const std::string& name, const IsThere& is_there) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kServerPatience);
  while (!is_there()) {
    if (!goesOn()) throw std::runtime_error("interrupted");
    if (ros::WallTime::now() > end) throw std::runtime_error("nobody offers " + name);
    ros::WallDuration(kPollPeriod).sleep();
  }
}

template <typename Client>
void waitForServer(const Client& client, const std::string& name) {
  waitFor(name, [&client] { return client.isServerConnected(); });
}

// actionlib's clients wait for a simulated clock to begin, deaf to interrupts.
void waitForClock() {
  while (!ros::Time::isValid()) {
    if (!goesOn()) throw std::runtime_error("interrupted");
    ros::WallDuration(kPollPeriod).sleep();
  }
}

// Not waitForResult(), which would not notice an interrupt.
template <typename Client>
void waitForResult(Client& client) {
  while (!client.getState().isDone()) {
    if (!goesOn()) {
      client.cancelGoal();
      ros::WallDuration(kPollPeriod).sleep();  // lets the cancel out
      throw std::runtime_error("interrupted");
    }
    ros::WallDuration(kPollPeriod).sleep();
  }
}

/// The person before the terminal, who answers on a thread of their own; nobody where they are not
/// asked.
class Person {
 public:
  Person(bool is_asked, const std::string& vocabulary, const phrasing::Phrases& phrases) {
    if (!is_asked) return;
    dialogue_ = std::make_unique<ConsoleDialogue>(ros::NodeHandle{}, STDIN_FILENO, terminal_,
                                                  dialogues::vocabularyOf(vocabulary), phrases);
    talk_ = std::thread([this] { dialogue_->run(); });
  }
  ~Person() {
    ros::shutdown();  // or the dialogue would go on
    if (talk_.joinable()) talk_.join();
  }
  Person(const Person&) = delete;
  Person& operator=(const Person&) = delete;

  bool isAsked() const { return dialogue_ != nullptr; }
  bool hasGone() const { return dialogue_ && dialogue_->hasEnded(); }
  std::ostream& hears() { return told_; }
  std::optional<std::size_t> choose(const std::vector<AlternativeGoal>& alternatives,
                                    const std::function<bool()>& is_gone) {
    return dialogue_->choose(alternatives, is_gone);
  }

 private:
  PromptedTerminal terminal_{std::cout};
  dialogues::TerminalStream told_{terminal_};
  std::unique_ptr<ConsoleDialogue> dialogue_;
  std::thread talk_;
};

/// Hears how the goals of others end, such as one by which a panel takes up an alternative.
class Plans {
 public:
  explicit Plans(ros::NodeHandle& node)
      : results_(node.subscribe(std::string(ros_common::kAlignerAlignAction) + "/result", 10,
                                &Plans::hear, this)) {}

  /// Whether a goal of the session has ended with a plan.
  std::optional<AlignResult> of(const std::string& session_id) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return newest_.session_id == session_id ? std::optional(newest_) : std::nullopt;
  }

 private:
  void hear(const AlignActionResult::ConstPtr& end) {
    if (end->result.outcome != AlignResult::SUCCESS) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = end->result;
  }

  mutable std::mutex mutex_;
  AlignResult newest_;
  ros::Subscriber results_;
};

/// The alignment of one task, told as it goes.
class Alignment {
 public:
  /// Where not all that is wanted can be had, the likeliest alternative is taken up if it
  /// `settles` for that; else the person is asked, or somebody else has to choose.
  Alignment(ros::NodeHandle& node, DemoNarrator& story, Person& person, bool settles)
      : story_(story),
        person_(person),
        settles_(settles),
        plans_(node),
        client_(node, ros_common::kAlignerAlignAction, false) {
    const boost::function<void(const AlignmentState::ConstPtr&)> hear_state =
        [this](const AlignmentState::ConstPtr& state) {
          story_.hear(*state);
          hears_states_ = true;
        };
    const boost::function<void(const Question::ConstPtr&)> hear_question =
        [this](const Question::ConstPtr& question) {
          story_.hear(*question);
          hears_questions_ = true;
        };
    states_ =
        node.subscribe<AlignmentState>(ros_common::kAlignerStateTopic, kQueueSize, hear_state);
    questions_ =
        node.subscribe<Question>(ros_common::kAlignerQuestionTopic, kQueueSize, hear_question);
  }

  Plan run(const HumanTask& task) {
    waitForServer(client_, ros_common::kAlignerAlignAction);
    // The last ones are latched; a short task would end before the topics are heard.
    waitFor(ros_common::kAlignerStateTopic, [this] { return hears_states_.load(); });
    waitFor(ros_common::kAlignerQuestionTopic, [this] { return hears_questions_.load(); });
    AlignGoal goal;
    goal.task = task;
    goal.source = AlignGoal::PARAMS;
    goal.max_questions = -1;
    goal.unsure_policy = AlignGoal::KEEP;
    AlignResult result = resultOf(goal);
    while (result.outcome != AlignResult::SUCCESS && !result.alternatives.empty()) {
      const auto chosen = settles_ ? std::optional<std::size_t>(0) : choice(result);
      if (!chosen) return planOfOthers(result);
      const AlternativeGoal& alternative = result.alternatives.at(*chosen);
      story_.takeUp(alternative);
      goal.continue_session = result.session_id;
      goal.revised_not_wanted = alternative.given_up;
      result = resultOf(goal);
    }
    if (result.outcome != AlignResult::SUCCESS)
      throw std::runtime_error("the task ended without a plan");
    return result.plan;
  }

 private:
  using AlignClient = actionlib::SimpleActionClient<AlignAction>;
  static constexpr std::uint32_t kQueueSize = 1000;

  AlignResult resultOf(const AlignGoal& goal) {
    client_.sendGoal(goal);
    while (!client_.getState().isDone()) {
      if (!goesOn() || person_.hasGone()) {
        client_.cancelGoal();
        ros::WallDuration(kPollPeriod).sleep();  // lets the cancel out
        throw std::runtime_error(goesOn() ? "nobody is left to answer" : "interrupted");
      }
      ros::WallDuration(kPollPeriod).sleep();
    }
    const auto result = client_.getResult();
    if (!result) throw std::runtime_error("the alignment gave no result");
    tell(*result);
    return *result;
  }

  // States and questions may come later than the result.
  void tell(const AlignResult& result) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kStoryPatience);
    while (goesOn() && !story_.hasHeardAllOf(result) && ros::WallTime::now() < end)
      ros::WallDuration(kPollPeriod).sleep();
    story_.hear(result);
  }

  // Nothing where somebody else has chosen.
  std::optional<std::size_t> choice(const AlignResult& result) {
    story_.awaitChoice();
    if (!person_.isAsked()) return std::nullopt;
    const auto is_gone = [&] { return plans_.of(result.session_id).has_value(); };
    const auto chosen = person_.choose(result.alternatives, is_gone);
    if (chosen || is_gone()) return chosen;
    story_.leaveIt();
    throw std::runtime_error("the task ended without a plan");
  }

  Plan planOfOthers(const AlignResult& ended) {
    while (goesOn()) {
      if (const auto found = plans_.of(ended.session_id)) {
        tell(*found);
        return found->plan;
      }
      ros::WallDuration(kPollPeriod).sleep();
    }
    throw std::runtime_error("interrupted");
  }

  DemoNarrator& story_;
  Person& person_;
  bool settles_;
  Plans plans_;
  std::atomic<bool> hears_states_{false};
  std::atomic<bool> hears_questions_{false};
  ros::Subscriber states_;
  ros::Subscriber questions_;
  AlignClient client_;
};

void execute(ros::NodeHandle& node, DemoNarrator& story, const Plan& plan) {
  using Client = actionlib::SimpleActionClient<ExecutePlanAction>;
  Client client(node, execution::kExecutePlanAction, false);
  waitForServer(client, execution::kExecutePlanAction);
  ExecutePlanGoal goal;
  goal.plan = plan;
  Plan running = plan;
  client.sendGoal(goal, {}, {}, [&](const ExecutePlanFeedback::ConstPtr& feedback) {
    if (!feedback->message.empty()) story.hearTrouble(feedback->message);
    if (feedback->new_plan.plan_id > 0) {
      running = feedback->new_plan;
      story.hearNewPlan(running);
    } else if (feedback->step >= 0) {
      story.hearStep(running, static_cast<std::size_t>(feedback->step));
    }
  });
  waitForResult(client);
  const auto result = client.getResult();
  if (!result) throw std::runtime_error("the executor gave no result");
  story.hearEnd(result->plan.plan_id > 0 ? result->plan : plan, *result);
  if (result->outcome != ExecutePlanResult::SUCCESS) {
    throw std::runtime_error("the plan was not carried out");
  }
}

void run() {
  ros::NodeHandle node;
  const ros::NodeHandle private_node("~");
  std::string file;
  if (!private_node.getParam("task", file))
    throw std::invalid_argument(private_node.resolveName("task") + " is not set");
  const HumanTask task = nodes::taskOfFile(file);
  ros::AsyncSpinner spinner(3);  // one for a question that waits for its answer
  spinner.start();
  const phrasing::Phrases phrases =
      aligner::phrasesOf(private_node.param<std::string>("phrases", ""));
  Person person(private_node.param("interactive", false),
                private_node.param<std::string>("vocabulary", dialogues::kDefaultVocabulary),
                phrases);
  DemoNarrator story(person.hears(), phrases, !person.isAsked());
  story.begin(task);
  waitForClock();
  const bool settles = private_node.param("settles", !person.isAsked());
  const Plan plan = Alignment(node, story, person, settles).run(task);
  execute(node, story, plan);
}

}  // namespace

int main(int argc, char** argv) {
  goal_alignment::ros_common::logInUtf8();
  ros::init(argc, argv, "demo_task", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  try {
    run();
  } catch (const std::exception& error) {
    std::cerr << "demo_task: " << error.what() << std::endl;
    return 1;
  }
}
