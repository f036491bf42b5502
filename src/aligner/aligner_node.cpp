// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/aligner/aligner_node.h"

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#include "align_server.h"
#include "alignment_runner.h"
#include "announcer.h"
#include "ask_human_client.h"
#include "diagnostics.h"
#include "explainer.h"
#include "goal_alignment/Answer.h"
#include "goal_alignment/Explain.h"
#include "goal_alignment/GetFacts.h"
#include "goal_alignment/GetState.h"
#include "goal_alignment/HumanTask.h"
#include "goal_alignment/SetFacts.h"
#include "goal_alignment/Validate.h"
#include "journal.h"
#include "marker_publisher.h"
#include "parameter_models.h"
#include "plan_watch.h"
#include "question_bridge.h"
#include "robot_facts.h"
#include "task_intake.h"
#include "tf_state_bridge.h"
#include "under_way.h"

#include <fmt/format.h>
#include <ros/advertise_service_options.h>
#include <ros/console.h>

#include <chrono>
#include <exception>

#include "align_goal_reader.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/ros_common/names.h"
#include "goal_alignment/ros_common/package_files.h"
#include "goal_alignment/ros_common/stamp.h"
#include "node_options.h"

namespace goal_alignment::aligner {
namespace {

constexpr std::uint32_t kStatusQueueSize = 100;  // a goal may end within the message after it began
constexpr std::uint32_t kExplainThreads = 2;     // each may wait for a reason to come up
// Others need some time to find a node that was restarted.
constexpr double kNewsPeriod = 1;  // seconds
constexpr int kMaxNewsPeriods = 10;

std::string stateFolder() {
  return ros_common::rosHome() + "/" + ros_common::kStateFolder;
}

QuestionIds questionIds() {
  QuestionIds ids(stateFolder() + "/question_id");
  if (!ids.lastError().empty()) {
    ROS_WARN("question ids may repeat after a restart: %s", ids.lastError().c_str());
  }
  return ids;
}

std::vector<JournalAnswer> toJournal(const std::vector<AcceptedAnswer>& answers) {
  std::vector<JournalAnswer> entries;
  for (const AcceptedAnswer& answer : answers) {
    if (answer.kind == session::AnswerKind::Decline) continue;
    for (const Literal& fluent : answer.fluents)
      entries.push_back({fluent, answer.kind, answer.answered_by, answer.at});
  }
  return entries;
}

void logWarning(const std::string& line) {
  ROS_WARN("%s", line.c_str());
}

std::string lostTask(const UnderWay::Task& task, const char* what_it_did) {
  return fmt::format("I was restarted while the task {}{}{}{}: send it again to go on",
                     task.task_id, task.task_id.empty() ? "" : " ",
                     task.person.empty() ? "" : "of " + task.person + " ", what_it_did);
}

}  // namespace

// goal_alignment_node: puts the parts together and offers the services. No callback runs a solver;
// what takes longer than a look-up has callback queues of its own, so that answers and cancels
// never wait behind it.
class AlignerNode::Implementation {
 public:
  Implementation(ros::NodeHandle node, ros::NodeHandle private_node);

  // The last words: every goal gets its result.
  void endGoals() { align_.endGoals(); }

 private:
  AlignGoal goalFor(const HumanTask& task) const;
  void hearExecutor(const actionlib_msgs::GoalStatusArray::ConstPtr& goals);
  bool refusesIfBusy() const;
  void noteWaiting(const std::vector<WaitingTask>& tasks);
  bool answer(Answer::Request& request, Answer::Response& response);
  bool reviseAnswer(Answer::Request& request, Answer::Response& response);
  bool getState(GetState::Request& request, GetState::Response& response);
  bool validate(Validate::Request& request, Validate::Response& response);
  bool explain(Explain::Request& request, Explain::Response& response);
  bool forget(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool setFacts(SetFacts::Request& request, SetFacts::Response& response);
  bool setHumanFacts(SetFacts::Request& request, SetFacts::Response& response);
  bool forgetFacts(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool getFacts(GetFacts::Request& request, GetFacts::Response& response);
  session::SubmitResult submit(const Answer::Request& request);
  void checkParameters();
  void takeUpKeptFacts(const NodeOptions& options);
  void tellOfLostTask();
  void tellNews();
  void wakeUpSolver();

  template <typename Service>
  ros::ServiceServer advertise(const char* name, ros::CallbackQueue& queue,
                               bool (Implementation::*method)(typename Service::Request&,
                                                              typename Service::Response&));

  ros::NodeHandle private_node_;
  Announcer announcer_;
  Journal journal_;
  Diagnostics diagnostics_;
  tf2_ros::Buffer frames_;
  tf2_ros::TransformListener frame_listener_;
  MarkerPublisher markers_;
  FactFile fact_file_;
  RobotFacts facts_;
  ParameterModels models_;
  UnderWay under_way_;
  TfStateBridge tf_;
  Explainer explainer_;
  QuestionBridge bridge_;
  AskHumanClient ask_human_;
  PlanWatch plan_watch_;
  AlignmentRunner runner_;
  AlignServer align_;
  TaskIntake tasks_;

  ros::Subscriber executor_;
  ros::ServiceServer answer_service_;
  ros::ServiceServer revise_service_;
  ros::ServiceServer state_service_;
  ros::ServiceServer forget_service_;
  ros::ServiceServer set_facts_service_;

  ros::CallbackQueue validate_callbacks_;
  ros::CallbackQueue explain_callbacks_;
  ros::CallbackQueue facts_callbacks_;
  ros::ServiceServer validate_service_;
  ros::ServiceServer explain_service_;
  ros::ServiceServer set_human_facts_service_;
  ros::ServiceServer forget_facts_service_;
  ros::ServiceServer get_facts_service_;
  ros::AsyncSpinner validate_spinner_;
  ros::AsyncSpinner explain_spinner_;
  ros::AsyncSpinner facts_spinner_;

  std::vector<std::string> news_;  // of the start, told once others have had time to listen
  int news_waited_ = 0;
  ros::WallTimer news_timer_;
};

template <typename Service>
ros::ServiceServer AlignerNode::Implementation::advertise(
    const char* name, ros::CallbackQueue& queue,
    bool (Implementation::*method)(typename Service::Request&, typename Service::Response&)) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  ros::AdvertiseServiceOptions options;
  options.init<Request, Response>(name, [this, method](Request& request, Response& response) {
    return (this->*method)(request, response);
  });
  options.callback_queue = &queue;
  return private_node_.advertiseService(options);
}

AlignerNode::Implementation::Implementation(ros::NodeHandle node, ros::NodeHandle private_node)
    : private_node_(private_node),
      announcer_(private_node),
      journal_(stateFolder() + "/journal", logWarning),
      diagnostics_(node, private_node, announcer_, journal_),
      frame_listener_(frames_, node),
      markers_(private_node, announcer_, frames_),
      fact_file_(stateFolder() + "/facts", private_node.getNamespace(), logWarning),
      facts_(&fact_file_),
      models_(private_node),
      under_way_(stateFolder() + "/under_way", private_node.getNamespace(), logWarning),
      tf_(frames_),
      explainer_([this] { wakeUpSolver(); }),
      bridge_(questionIds(),
              [this](const std::string& session_id, const std::vector<AcceptedAnswer>& answers) {
                journal_.add(session_id, toJournal(answers));
              }),
      ask_human_(
          node, [this](const Answer::Request& request) { return submit(request); },
          [this](const std::string& complaint) { announcer_.tell(complaint); }),
      runner_(private_node, {announcer_, bridge_, ask_human_, journal_, facts_, under_way_, tf_,
                             explainer_, plan_watch_}),
      align_(
          private_node, runner_, announcer_, plan_watch_, [this] { return refusesIfBusy(); },
          [this](const std::vector<WaitingTask>& tasks) { noteWaiting(tasks); }),
      tasks_(node, stateFolder(), align_, announcer_,
             [this](const HumanTask& task) { return goalFor(task); }),
      executor_(node.subscribe(ros_common::kExecutorStatusTopic, kStatusQueueSize,
                               &Implementation::hearExecutor, this)),
      answer_service_(
          private_node.advertiseService(ros_common::kAnswerService, &Implementation::answer, this)),
      revise_service_(private_node.advertiseService(ros_common::kReviseAnswerService,
                                                    &Implementation::reviseAnswer, this)),
      state_service_(private_node.advertiseService(ros_common::kGetStateService,
                                                   &Implementation::getState, this)),
      forget_service_(
          private_node.advertiseService(ros_common::kForgetService, &Implementation::forget, this)),
      set_facts_service_(private_node.advertiseService(ros_common::kSetFactsService,
                                                       &Implementation::setFacts, this)),
      validate_service_(advertise<Validate>(ros_common::kValidateService, validate_callbacks_,
                                            &Implementation::validate)),
      explain_service_(advertise<Explain>(ros_common::kExplainService, explain_callbacks_,
                                          &Implementation::explain)),
      set_human_facts_service_(advertise<SetFacts>(
          ros_common::kSetHumanFactsService, facts_callbacks_, &Implementation::setHumanFacts)),
      forget_facts_service_(advertise<std_srvs::Trigger>(
          ros_common::kForgetFactsService, facts_callbacks_, &Implementation::forgetFacts)),
      get_facts_service_(advertise<GetFacts>(ros_common::kGetFactsService, facts_callbacks_,
                                             &Implementation::getFacts)),
      validate_spinner_(1, &validate_callbacks_),
      explain_spinner_(kExplainThreads, &explain_callbacks_),
      facts_spinner_(1, &facts_callbacks_) {
  checkParameters();
  if (!news_.empty()) {
    news_timer_ = private_node_.createWallTimer(ros::WallDuration(kNewsPeriod),
                                                [this](const ros::WallTimerEvent&) { tellNews(); });
  }
  validate_spinner_.start();
  explain_spinner_.start();
  facts_spinner_.start();
}

// It waits for an answer, or for a goal, or is at work and looks later.
void AlignerNode::Implementation::wakeUpSolver() {
  bridge_.wakeUp();
  align_.wakeUp();
}

// A faulty parameter is told at the start, though only the next goal would be refused for it. And
// the rules of tf and the facts kept count from now on, so that ~get_facts can tell of them.
void AlignerNode::Implementation::checkParameters() {
  try {
    const NodeOptions options = NodeOptions::read(private_node_);
    takeUpKeptFacts(options);
    if (options.journal_expiry > 0) tellOfLostTask();
    tf_.follow(rulesOf(options.tf_facts));
  } catch (const ros_common::ParameterError& error) {
    ROS_ERROR("%s", error.what());
  } catch (const GoalError& error) {
    ROS_ERROR("%s", error.what());
  }
}

// Else the next task does, whose models come from parameters.
void AlignerNode::Implementation::takeUpKeptFacts(const NodeOptions& options) {
  try {
    const FactScope scope = FactScope::of(parameterModels(options), options.world);
    const std::string line = facts_.follow(scope, options.facts_expiry);
    if (!line.empty()) news_.push_back(line);
  } catch (const std::exception& error) {
    ROS_DEBUG("no facts are taken up yet: %s", error.what());
  }
}

// Who sent it as an action's goal sees that it is lost, as the new server does not know it.
void AlignerNode::Implementation::tellOfLostTask() {
  const UnderWay::Tasks lost = under_way_.lost();
  if (lost.running) {
    AlignmentState state;
    state.phase = AlignmentState::DONE;
    state.session_id = lost.running->session_id;
    state.task_id = lost.running->task_id;
    state.person = lost.running->person;
    state.outcome = AlignResult::CANCELED;
    state.message = lostTask(*lost.running, "was under way");
    announcer_.publish(state);
    news_.push_back(state.message);
  }
  for (const UnderWay::Task& task : lost.waiting)
    news_.push_back(lostTask(task, "waited"));
}

void AlignerNode::Implementation::tellNews() {
  if (!announcer_.isHeard() && ++news_waited_ < kMaxNewsPeriods) return;
  news_timer_.stop();
  for (const std::string& line : news_)
    announcer_.tell(line);
}

AlignGoal AlignerNode::Implementation::goalFor(const HumanTask& task) const {
  AlignGoal goal;
  goal.task = task;
  goal.source = AlignGoal::PARAMS;
  goal.max_questions = -1;
  goal.unsure_policy = AlignGoal::KEEP;
  return goal;
}

void AlignerNode::Implementation::hearExecutor(
    const actionlib_msgs::GoalStatusArray::ConstPtr& goals) {
  plan_watch_.hear(goals->status_list);
  align_.lookAtExecutor();
}

// With journal_expiry 0 nothing is kept on disk, as for the task under way. Reads that one
// parameter, not all of NodeOptions, since the queue is locked meanwhile.
void AlignerNode::Implementation::noteWaiting(const std::vector<WaitingTask>& tasks) {
  double journal_expiry = NodeOptions().journal_expiry;
  private_node_.getParam("journal_expiry", journal_expiry);
  std::vector<UnderWay::Task> noted;
  if (journal_expiry > 0) {
    for (const WaitingTask& task : tasks)
      noted.push_back({"", task.task_id, task.person});
  }
  under_way_.wait(std::move(noted));
}

bool AlignerNode::Implementation::refusesIfBusy() const {
  try {
    return NodeOptions::read(private_node_).busy_policy == BusyPolicy::Refuse;
  } catch (const ros_common::ParameterError&) {
    return false;  // the goal is refused for it when its turn comes, and then says so
  }
}

session::SubmitResult AlignerNode::Implementation::submit(const Answer::Request& request) {
  const session::SubmitResult receipt = bridge_.submit(request);
  if (receipt.accepted) diagnostics_.countAnswer(request.answered_by);
  return receipt;
}

bool AlignerNode::Implementation::answer(Answer::Request& request, Answer::Response& response) {
  const session::SubmitResult receipt = submit(request);
  response.accepted = receipt.accepted;
  response.message = receipt.message;
  return true;
}

bool AlignerNode::Implementation::reviseAnswer(Answer::Request& request,
                                               Answer::Response& response) {
  const QuestionBridge::Revision revision = bridge_.revise(request);
  response.accepted = revision.receipt.accepted;
  response.message = revision.receipt.message;
  if (revision.receipt.accepted) diagnostics_.countAnswer(request.answered_by);
  // After an outcome the session goes on with a goal of its own, which takes the answer up.
  if (revision.receipt.accepted && !revision.continue_session.empty()) {
    AlignGoal goal;
    goal.continue_session = revision.continue_session;
    goal.max_questions = -1;
    goal.unsure_policy = AlignGoal::KEEP;
    align_.submit(goal, ros_common::kReviseAnswerService);
  }
  return true;
}

bool AlignerNode::Implementation::getState(GetState::Request& /*request*/,
                                           GetState::Response& response) {
  // In this order, so that none can be missed in between.
  const QuestionBridge::Unshown unshown = bridge_.unshown();
  response.state = announcer_.state();
  unshown.addTo(response.state);
  return true;
}

bool AlignerNode::Implementation::validate(Validate::Request& request,
                                           Validate::Response& response) {
  response.errors = pddl::faults({"domain", request.domain}, {"problem", request.problem});
  response.valid = response.errors.empty();
  return true;
}

bool AlignerNode::Implementation::explain(Explain::Request& request, Explain::Response& response) {
  response =
      explainer_.explain(request, std::chrono::duration<double>(ros_common::kExplainSeconds));
  return true;
}

bool AlignerNode::Implementation::forget(std_srvs::Trigger::Request& /*request*/,
                                         std_srvs::Trigger::Response& response) {
  response.success = journal_.forget();
  response.message = response.success ? "the answers of the current task are not kept on disk"
                                      : "there is no task to forget";
  return true;
}

bool AlignerNode::Implementation::setFacts(SetFacts::Request& request,
                                           SetFacts::Response& response) {
  const session::SubmitResult receipt = facts_.set(request.facts, tf_.rules().get());
  response.accepted = receipt.accepted;
  response.message = receipt.message;
  if (receipt.accepted) bridge_.wakeUp();
  return true;
}

bool AlignerNode::Implementation::getFacts(GetFacts::Request& /*request*/,
                                           GetFacts::Response& response) {
  const spatial_facts::Observation seen = tf_.look();
  response = facts_.tell(seen);
  if (!response.session_id.empty()) return true;
  std::string why_not;
  const ParameterModels::Model next = models_.robot(why_not);
  response = facts_.tellBefore(next, why_not, seen);
  return true;
}

// Where their model can't be read, the next task finds out what it can't have.
bool AlignerNode::Implementation::setHumanFacts(SetFacts::Request& request,
                                                SetFacts::Response& response) {
  std::string why_not;
  const ParameterModels::Model human = models_.human(why_not);
  const session::SubmitResult receipt = facts_.setHuman(request.facts, human.get());
  response.accepted = receipt.accepted;
  response.message = receipt.message;
  if (receipt.accepted && !human)
    response.message = "taken; the person's model can't be read: " + why_not;
  return true;
}

bool AlignerNode::Implementation::forgetFacts(std_srvs::Trigger::Request& /*request*/,
                                              std_srvs::Trigger::Response& response) {
  response.success = 1;
  response.message = fmt::format(
      "all facts that were set are forgotten ({}): what is so stands in the problem files",
      facts_.forget());
  bridge_.wakeUp();
  return true;
}

AlignerNode::AlignerNode(ros::NodeHandle node, ros::NodeHandle private_node)
    : implementation_(std::make_unique<Implementation>(std::move(node), std::move(private_node))) {}

AlignerNode::~AlignerNode() = default;

void AlignerNode::endGoals() {
  implementation_->endGoals();
}

}  // namespace goal_alignment::aligner
