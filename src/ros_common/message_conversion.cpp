// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/message_conversion.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "goal_alignment/common/quote.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/lexer.h"
#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::ros_common {
namespace {

std::string nameOf(const std::string& text, const std::string& what) {
  if (text.empty()) throw std::invalid_argument(what + " is empty");
  if (!isName(text)) {
    throw std::invalid_argument(fmt::format("{} {} is not a PDDL name", what, inQuotes(text)));
  }
  return toLower(text);
}

GroundName toGroundName(const std::string& name, const std::vector<std::string>& args) {
  GroundName ground;
  ground.name = nameOf(name, "the name");
  for (std::size_t i = 0; i < args.size(); ++i) {
    ground.arguments.push_back(nameOf(args[i], fmt::format("argument {} of '{}'", i, name)));
  }
  return ground;
}

// Calls convert on each element; an error says which element of which field it was.
template <typename Result, typename Message, typename Convert>
std::vector<Result> convertAll(const std::vector<Message>& messages, const std::string& field,
                               Convert convert) {
  std::vector<Result> results;
  results.reserve(messages.size());
  for (std::size_t i = 0; i < messages.size(); ++i) {
    try {
      results.push_back(convert(messages[i]));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}[{}]: {}", field, i, error.what()));
    }
  }
  return results;
}

diagnostic_msgs::KeyValue keyValue(const std::string& key, const std::string& value) {
  diagnostic_msgs::KeyValue message;
  message.key = key;
  message.value = value;
  return message;
}

std::uint16_t toIndex(std::size_t index) {
  return static_cast<std::uint16_t>(
      std::min<std::size_t>(index, std::numeric_limits<std::uint16_t>::max()));
}

std::uint32_t toCount(std::size_t count) {
  return static_cast<std::uint32_t>(
      std::min<std::size_t>(count, std::numeric_limits<std::uint32_t>::max()));
}

ActionDispatch toDispatch(const GroundName& step, const std::vector<std::string>& keys,
                          std::int32_t plan_id, std::size_t index) {
  ActionDispatch message;
  message.action_id = static_cast<std::int32_t>(index);
  message.plan_id = plan_id;
  message.name = step.name;
  for (std::size_t i = 0; i < step.arguments.size(); ++i) {
    message.parameters.push_back(
        keyValue(i < keys.size() ? keys[i] : std::to_string(i), step.arguments[i]));
  }
  return message;
}

}  // namespace

bool isName(const std::string& text) {
  // What a model may call something, a message may. Comments and blanks are left out between words.
  const pddl::Source source{"", text};
  std::size_t length = 0;
  try {
    pddl::Lexer lexer(source);
    for (auto token = lexer.next(); token.kind == pddl::Token::Kind::Word; token = lexer.next())
      length += token.text.size();
  } catch (const pddl::SyntaxError&) {
    return false;
  }
  return !text.empty() && length == text.size();
}

Literal toLiteral(const Fluent& fluent) {
  return Literal{toGroundName(fluent.name, fluent.args), fluent.negated != 0};
}

std::vector<Literal> toLiterals(const std::vector<Fluent>& fluents, const std::string& field) {
  return convertAll<Literal>(fluents, field, toLiteral);
}

GroundName toAction(const PlanStep& step) {
  return toGroundName(step.name, step.args);
}

std::vector<GroundName> toActions(const std::vector<PlanStep>& steps, const std::string& field) {
  return convertAll<GroundName>(steps, field, toAction);
}

std::vector<Literal> toLiterals(const std::vector<std::string>& texts) {
  return convertAll<Literal>(texts, "fluents", [](const std::string& text) {
    const Literal literal = Literal::parse(text);
    return Literal{toGroundName(literal.atom.name, literal.atom.arguments), literal.negated};
  });
}

Fluent toMessage(const Literal& literal, const phrasing::Phrases& phrases) {
  Fluent message;
  message.name = literal.atom.name;
  message.args = literal.atom.arguments;
  message.negated = literal.negated;
  message.text = phrases.clause(literal);
  return message;
}

std::vector<Fluent> toMessage(const std::vector<Literal>& literals,
                              const phrasing::Phrases& phrases) {
  std::vector<Fluent> messages;
  messages.reserve(literals.size());
  for (const Literal& literal : literals)
    messages.push_back(toMessage(literal, phrases));
  return messages;
}

Candidate toMessage(const session::CandidateView& view, const phrasing::Phrases& phrases,
                    const AnswerTimes& times) {
  Candidate message;
  message.fluent = toMessage(view.fluent, phrases);
  message.state = static_cast<std::uint8_t>(view.state);
  message.probability = view.probability;
  message.achievable = view.achievable;
  for (const std::size_t index : view.conflicts)
    message.conflicts.push_back(toIndex(index));
  message.answered_by = view.assumed ? kAssumed : view.answered_by;
  const auto time = times.find(view.fluent);
  if (time != times.end()) message.answered_at = time->second;
  return message;
}

Conflict toMessage(const session::ConflictView& view, const phrasing::Phrases& phrases) {
  Conflict message;
  message.fluents = toMessage(view.fluents, phrases);
  message.proven = view.proven;
  message.minimal = view.minimal;
  message.live = view.live;
  return message;
}

Question toMessage(const session::QuestionView& view, const phrasing::Phrases& phrases) {
  Question message;
  message.fluents = toMessage(view.fluents, phrases);
  message.text = phrases.question(view.fluents, view.at_end);
  message.why = phrases.why(view.reasons, view.if_yes, view.if_no, view.bound_is_provisional);
  const auto reason =
      std::find_if(view.reasons.begin(), view.reasons.end(),
                   [](const session::Reason& each) { return !each.conflict.empty(); });
  if (reason != view.reasons.end()) message.conflict = toMessage(reason->conflict, phrases);
  message.probabilities = view.probabilities;
  message.asked = toCount(view.asked);
  message.max_remaining = toCount(view.max_remaining);
  message.bound_is_provisional = view.bound_is_provisional;
  return message;
}

AlternativeGoal toMessage(const session::Alternative& alternative,
                          const phrasing::Phrases& phrases) {
  AlternativeGoal message;
  message.given_up = toMessage(alternative.given_up, phrases);
  message.probability = alternative.probability;
  return message;
}

AlignmentState toMessage(const session::Snapshot& snapshot, const phrasing::Phrases& phrases,
                         const AnswerTimes& times) {
  AlignmentState message;
  message.phase = phaseOf(snapshot.state);
  if (snapshot.planning) message.phase = AlignmentState::PLANNING;
  message.progress = snapshot.progress;
  message.specified = toMessage(snapshot.specified, phrases);
  for (const auto& view : snapshot.candidates) {
    message.candidates.push_back(toMessage(view, phrases, times));
  }
  for (const auto& view : snapshot.conflicts) {
    message.conflicts.push_back(toMessage(view, phrases));
  }
  message.conflicts_complete = snapshot.conflicts_complete;
  message.questions_asked = toCount(snapshot.questions_asked);
  message.max_remaining = toCount(snapshot.max_remaining);
  return message;
}

std::uint8_t phaseOf(session::State state) {
  switch (state) {
    case session::State::Idle:
      return AlignmentState::IDLE;
    case session::State::Analysing:
      return AlignmentState::ANALYSING;
    case session::State::AwaitingAnswer:
      return AlignmentState::AWAITING_ANSWER;
    case session::State::Done:
      return AlignmentState::DONE;
  }
  return AlignmentState::IDLE;
}

Plan toMessage(const session::Session& session, std::int32_t plan_id,
               const phrasing::Phrases& phrases) {
  const session::FinalPlan& plan = session.outcome().plan;
  Plan message;
  message.plan_id = plan_id;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const GroundName& step = plan.steps[i];
    message.steps.push_back(toDispatch(step, session.parameterNames(step.name), plan_id, i));
    message.step_texts.push_back(phrases.action(step));
  }
  message.guaranteed = toMessage(plan.guaranteed, phrases);
  message.kept_unasked = toMessage(plan.kept_unasked, phrases);
  message.not_wanted = toMessage(plan.not_wanted, phrases);
  message.assumed_not_wanted = toMessage(plan.assumed_not_wanted, phrases);
  message.extra_cost = static_cast<double>(plan.extra_cost);
  message.cost = static_cast<double>(plan.cost);
  message.optimal = plan.optimal;
  return message;
}

AlignResult toMessage(const session::Outcome& outcome, const phrasing::Phrases& phrases) {
  AlignResult message;
  message.outcome = static_cast<std::uint16_t>(outcome.code);
  message.message = outcome.message;
  message.conflict = toMessage(outcome.conflict, phrases);
  message.conflict_proven = outcome.conflict_proven;
  message.conflict_minimal = outcome.conflict_minimal;
  for (const auto& alternative : outcome.alternatives) {
    message.alternatives.push_back(toMessage(alternative, phrases));
  }
  message.failing_step = outcome.failing_step;
  return message;
}

}  // namespace goal_alignment::ros_common
