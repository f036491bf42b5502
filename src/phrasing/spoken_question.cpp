// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/spoken_question.h"

#include <utility>

namespace goal_alignment::phrasing {

namespace {

std::string spoken(const Vocabulary& vocabulary, const std::string& text,
                   const std::vector<std::string>& offered) {
  if (offered.size() < 2) return text;
  std::string all = vocabulary.which();
  for (std::size_t i = 0; i < offered.size(); ++i)
    all += " " + vocabulary.numbered(i, offered[i]);
  return all;
}

}  // namespace

SpokenQuestion::SpokenQuestion(const Vocabulary& vocabulary, const std::string& text,
                               std::string why, std::vector<std::string> offered, int retries)
    : vocabulary_(vocabulary),
      asked_(spoken(vocabulary, text, offered)),
      why_(std::move(why)),
      offered_(std::move(offered)),
      misunderstandings_left_(retries),
      silences_left_(retries) {}

SpokenQuestion::Turn SpokenQuestion::hear(const std::string& said) {
  if (const auto heard = vocabulary_.understand(said, offered_)) {
    switch (heard->kind) {
      case Heard::Kind::Reply:
        return {heard->reply, ""};
      case Heard::Kind::Repeat:
        return {std::nullopt, asked_};
      case Heard::Kind::Why:
        return {std::nullopt, why_.empty() ? vocabulary_.noReason() : why_};
    }
  }
  if (misunderstandings_left_ == 0) return {};
  --misunderstandings_left_;
  return {std::nullopt,
          vocabulary_.sorry() + " " + asked_ + " " + vocabulary_.answers(offered_.size() > 1)};
}

std::string SpokenQuestion::silence() {
  if (silences_left_ == 0) return "";
  --silences_left_;
  return asked_ + " " + vocabulary_.answers(offered_.size() > 1);
}

}  // namespace goal_alignment::phrasing
