// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// Every ROS name of the alignment's side of the graph, each once; those of the execution of plans
/// stand in execution/names.h. doc/interface.md lists them all.
namespace goal_alignment::ros_common {

constexpr const char* kPackage = "goal_alignment";
constexpr const char* kDefaultNodeName = "goal_alignment";

// Relative to the node's namespace.
constexpr const char* kHumanTaskTopic = "human_task";
constexpr const char* kAskHumanService = "ask_human";
constexpr const char* kExecutorStatusTopic = "execute_plan/status";
constexpr const char* kRecognisedSpeechTopic = "recognised_speech";

// Private to speech_dialogue.
constexpr const char* kSaidTopic = "said";

// Private to the aligner. Dialogue nodes find them below kDefaultNodeName, remap for another.
constexpr const char* kAlignAction = "align";
constexpr const char* kQuestionTopic = "question";
constexpr const char* kStateTopic = "state";
constexpr const char* kPlanTopic = "plan";
constexpr const char* kEventsTopic = "events";
constexpr const char* kMarkersTopic = "markers";
constexpr const char* kAnswerService = "answer";
constexpr const char* kReviseAnswerService = "revise_answer";
constexpr const char* kGetStateService = "get_state";
constexpr const char* kValidateService = "validate";
constexpr const char* kExplainService = "explain";
constexpr const char* kForgetService = "forget";
constexpr const char* kSetFactsService = "set_facts";
constexpr const char* kSetHumanFactsService = "set_human_facts";
constexpr const char* kForgetFactsService = "forget_facts";
constexpr const char* kGetFactsService = "get_facts";

constexpr const char* kAlignerQuestionTopic = "goal_alignment/question";
constexpr const char* kAlignerStateTopic = "goal_alignment/state";
constexpr const char* kAlignerAlignAction = "goal_alignment/align";

/// Below $ROS_HOME, or ~/.ros where that is not set.
constexpr const char* kStateFolder = "goal_alignment";

/// Who has answered what nobody was asked about.
constexpr const char* kAssumed = "assumed";

constexpr std::uint32_t kStateQueueSize = 10;  // latched; a slow reader may miss all but the newest
constexpr std::uint32_t kEventQueueSize = 100;

/// For so long after a question replaced another an answer must name the question it means.
constexpr double kAnswerGraceSeconds = 1.0;

/// For so long ~explain waits for a reason that the search has not brought up yet.
constexpr double kExplainSeconds = 2.0;

/// For so long at a time the session may think about a supposition: answers and cancels wait.
constexpr double kSupposeSeconds = 0.1;

}  // namespace goal_alignment::ros_common
