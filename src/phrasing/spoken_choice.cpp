// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/spoken_choice.h"

#include <utility>

namespace goal_alignment::phrasing {

SpokenChoice::SpokenChoice(const Vocabulary& vocabulary, const std::string& told,
                           std::size_t listed, std::vector<std::string> offered, int retries)
    : vocabulary_(vocabulary),
      sayings_(*vocabulary.atEnd()),
      offered_(std::move(offered)),
      misunderstandings_left_(retries),
      silences_left_(retries) {
  const bool several = offered_.size() > 1;
  asked_ = told + choices(listed) + " " + (several ? sayings_.choose : sayings_.choose_one);
}

// Of those that were not told yet.
std::string SpokenChoice::choices(std::size_t listed) const {
  if (offered_.size() == 1 && listed == 0)
    return " " + sayings_.offer_one.fill(offered_).value_or(offered_.front());
  std::string text = listed == 0 ? " " + sayings_.offer : "";
  for (std::size_t i = listed; i < offered_.size(); ++i)
    text += " " + vocabulary_.numbered(i, offered_[i]);
  return text;
}

std::string SpokenChoice::answers() const {
  return offered_.size() > 1 ? sayings_.choose_answers : vocabulary_.answers(false);
}

SpokenChoice::Turn SpokenChoice::hear(const std::string& said) {
  if (const auto choice = vocabulary_.choose(said, offered_)) {
    switch (choice->kind) {
      case Choice::Kind::One:
        return {true, choice->index, sayings_.chosen};
      case Choice::Kind::None:
        return {true, std::nullopt, sayings_.left};
      case Choice::Kind::Repeat:
        return {false, std::nullopt, asked_};
    }
  }
  if (misunderstandings_left_ == 0) return {true, std::nullopt, sayings_.left};
  --misunderstandings_left_;
  return {false, std::nullopt, vocabulary_.sorry() + " " + answers()};
}

SpokenChoice::Turn SpokenChoice::silence() {
  if (silences_left_ == 0) return {true, std::nullopt, ""};
  --silences_left_;
  return {false, std::nullopt, asked_ + " " + answers()};
}

std::string spokenPlan(const EndSayings& sayings, const std::vector<std::string>& steps) {
  if (steps.empty()) return "";
  if (steps.size() == 1) return sayings.plan_of_one.fill(steps).value_or("");
  return sayings.plan.fill({std::to_string(steps.size()), steps.front(), steps.back()})
      .value_or("");
}

}  // namespace goal_alignment::phrasing
