// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Explain.h"
#include "goal_alignment/GetFacts.h"
#include "goal_alignment/GetState.h"
#include "goal_alignment/SetFacts.h"
#include "goal_alignment/Validate.h"
#include "scenario.h"

/// The aligner's services and parameters, each in one line.
namespace goal_alignment::test {

/// A private parameter of the aligner, for as long as this lives.
class Parameter {
 public:
  template <typename Value>
  Parameter(const std::string& key, const Value& value) : name_("/goal_alignment/" + key) {
    ros::param::set(name_, value);
  }
  ~Parameter() { ros::param::del(name_); }
  Parameter(const Parameter&) = delete;
  Parameter& operator=(const Parameter&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// Calls a private service of the aligner.
template <typename Service>
typename Service::Response callAligner(const std::string& name,
                                       const typename Service::Request& request = {}) {
  Service service;
  service.request = request;
  EXPECT_TRUE(callService("/goal_alignment/" + name, service)) << name;
  return service.response;
}

inline Explain::Response explain(const std::vector<std::string>& fluents,
                                 int kind = Explain::Request::WHY) {
  Explain::Request request;
  request.kind = static_cast<std::uint8_t>(kind);
  request.fluents = fluents;
  return callAligner<Explain>("explain", request);
}

inline SetFacts::Response setFacts(const std::vector<Fluent>& facts) {
  SetFacts::Request request;
  request.facts = facts;
  return callAligner<SetFacts>("set_facts", request);
}

inline GetFacts::Response getFacts() {
  return callAligner<GetFacts>("get_facts");
}

inline Validate::Response validate(const std::string& domain, const std::string& problem) {
  Validate::Request request;
  request.domain = domain;
  request.problem = problem;
  return callAligner<Validate>("validate", request);
}

inline Answer::Response reviseAnswer(int value, const std::vector<std::string>& fluents) {
  Answer::Request request;
  request.answer = static_cast<std::int8_t>(value);
  request.fluents = fluents;
  request.answered_by = "reviser";
  return callAligner<Answer>("revise_answer", request);
}

inline AlignmentState currentState() {
  return callAligner<GetState>("get_state").state;
}

inline Fluent negated(Fluent fluent) {
  fluent.negated = 1;
  return fluent;
}

/// "(on a b)"
inline std::string textOf(const Fluent& fluent) {
  std::string text = "(" + fluent.name;
  for (const std::string& arg : fluent.args)
    text += " " + arg;
  return fluent.negated ? "(not " + text + "))" : text + ")";
}

inline std::vector<std::string> textsOf(const std::vector<Fluent>& fluents) {
  std::vector<std::string> texts;
  for (const Fluent& fluent : fluents)
    texts.push_back(textOf(fluent));
  std::sort(texts.begin(), texts.end());
  return texts;
}

}  // namespace goal_alignment::test
