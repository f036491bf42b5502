// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/make_shared.hpp>
#include <string>
#include <vector>

#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Plan.h"
#include "goal_alignment/Question.h"

/// Messages as an aligner sends them, for tests of the panel.
namespace goal_alignment::rviz_panel {

inline Fluent fluent(const std::string& name, const std::vector<std::string>& args,
                     const std::string& text = "") {
  Fluent message;
  message.name = name;
  message.args = args;
  message.text = text;
  return message;
}

inline Candidate candidate(const Fluent& fluent, int state, double probability) {
  Candidate message;
  message.fluent = fluent;
  message.state = static_cast<std::uint8_t>(state);
  message.probability = probability;
  message.achievable = 1;
  return message;
}

/// (at thing0 kitchen) … with beliefs that differ.
inline AlignmentState::Ptr stateWith(int candidates) {
  auto state = boost::make_shared<AlignmentState>();
  state->session_id = "s";
  state->task_id = "tidy-up";
  state->person = "Ada";
  state->phase = AlignmentState::AWAITING_ANSWER;
  for (int i = 0; i < candidates; ++i) {
    const std::string thing = "thing" + std::to_string(i);
    state->candidates.push_back(candidate(
        fluent("at", {thing, "kitchen"}, "the " + thing + " is where it belongs in the kitchen"),
        Candidate::OPEN, (i * 37 % 1000) / 1000.0));
  }
  return state;
}

inline Question::Ptr questionAbout(std::uint32_t id, const std::vector<Fluent>& fluents) {
  auto question = boost::make_shared<Question>();
  question->session_id = "s";
  question->question_id = id;
  question->fluents = fluents;
  question->text = "Does it matter to you that the tea is served in the china cup?";
  question->why =
      "I can't have both: that the china cup is used, and that the high shelf is left alone.";
  question->asked = 1;
  question->max_remaining = 3;
  return question;
}

inline Plan::Ptr planOf(std::size_t steps) {
  auto plan = boost::make_shared<Plan>();
  plan->session_id = "s";
  plan->plan_id = 1;
  for (std::size_t i = 0; i < steps; ++i) {
    ActionDispatch step;
    step.action_id = static_cast<int>(i);
    step.name = "go";
    plan->steps.push_back(step);
    plan->step_texts.push_back("go from the counter to the table");
  }
  plan->guaranteed = {fluent("tea-served", {}, "a cup of tea is served")};
  return plan;
}

}  // namespace goal_alignment::rviz_panel
