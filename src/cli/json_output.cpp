// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/cli/json_output.h"

#include <algorithm>
#include <iostream>

namespace goal_alignment::cli {

using session::AnswerKind;
using session::OutcomeCode;

namespace {

const char* word(AnswerKind answer) {
  switch (answer) {
    case AnswerKind::No:
      return "no";
    case AnswerKind::Yes:
      return "yes";
    case AnswerKind::Unsure:
      return "unsure";
    case AnswerKind::Decline:
      return "decline";
  }
  return "";
}

/// The reason of a question in a few words, with the PDDL fluents.
std::string why(const session::Reason& reason) {
  if (reason.extra_cost > 0)
    return "keeping it costs " + std::to_string(reason.extra_cost) + " more";
  if (reason.conflict.empty()) return "";
  std::string list;
  for (const Literal& literal : reason.conflict)
    list += (list.empty() ? "" : " and ") + literal.text();
  return (reason.proven ? "can't have " : "could not make sure to have ") + list +
         " together with the specified goal";
}

Json questionsOf(const session::Session& session) {
  Json list = Json::array();
  for (const session::QuestionRecord& record : session.questions()) {
    for (std::size_t i = 0; i < record.fluents.size(); ++i) {
      Json entry = {{"fluent", record.fluents[i].text()},
                    {"answer", word(record.answers[i])},
                    {"round", record.round}};
      if (const std::string reason = why(record.reasons[i]); !reason.empty()) entry["why"] = reason;
      list.push_back(std::move(entry));
    }
  }
  return list;
}

Json alternativesOf(const session::Outcome& outcome) {
  Json list = Json::array();
  for (const session::Alternative& alternative : outcome.alternatives) {
    list.push_back(
        {{"given_up", texts(alternative.given_up)}, {"probability", alternative.probability}});
  }
  return list;
}

}  // namespace

Json texts(const std::vector<Literal>& literals) {
  Json list = Json::array();
  for (const Literal& literal : literals)
    list.push_back(literal.text());
  return list;
}

Json texts(const std::vector<GroundName>& plan) {
  Json list = Json::array();
  for (const GroundName& step : plan)
    list.push_back(step.text());
  return list;
}

Json toJson(const session::Outcome& outcome) {
  return {{"outcome", session::outcomeWord(outcome.code)},
          {"code", static_cast<int>(outcome.code)},
          {"message", outcome.message}};
}

void print(const Json& json) {
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

Json toJson(const session::Session& session) {
  const session::Outcome& outcome = session.outcome();
  Json json = toJson(outcome);
  if (outcome.code == OutcomeCode::Success) {
    json["plan"] = texts(outcome.plan.steps);
    json["cost"] = outcome.plan.cost;
    json["optimal"] = outcome.plan.optimal;
    json["guaranteed"] = texts(outcome.plan.guaranteed);
    json["kept_unasked"] = texts(outcome.plan.kept_unasked);
    json["extra_cost"] = outcome.plan.extra_cost;
    json["not_wanted"] = texts(outcome.plan.not_wanted);
    if (!outcome.plan.assumed_not_wanted.empty())
      json["assumed_not_wanted"] = texts(outcome.plan.assumed_not_wanted);
  }
  const session::Snapshot view = session.snapshot();
  if (!view.specified.empty() || !view.candidates.empty()) {
    json["candidates"] = view.candidates.size();
    json["candidates_static"] = std::count_if(view.candidates.begin(), view.candidates.end(),
                                              [](const auto& c) { return c.is_static; });
  }
  json["questions"] = questionsOf(session);
  json["rounds"] = session.questions().size();
  const bool names_conflict =
      session::outcomeTraits(outcome.code).kind == session::OutcomeKind::NoPlan ||
      !outcome.conflict.empty();
  if (names_conflict) {
    json["conflict"] = texts(outcome.conflict);
    json["conflict_proven"] = outcome.conflict_proven;
    json["conflict_minimal"] = outcome.conflict_minimal;
  }
  if (outcome.code == OutcomeCode::ExpectationUnachievable || !outcome.alternatives.empty()) {
    json["alternatives"] = alternativesOf(outcome);
  }
  const session::Statistics& statistics = session.statistics();
  json["planner_calls"] = statistics.planner_calls;
  json["timing"] = {{"parse", statistics.parse},         {"ground", statistics.ground},
                    {"belief", statistics.belief},       {"conflicts", statistics.conflicts},
                    {"questions", statistics.questions}, {"plan", statistics.plan},
                    {"total", statistics.total}};
  return json;
}

}  // namespace goal_alignment::cli
