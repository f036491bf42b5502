// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_interface/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "goal_alignment/ros_interface/message_conversion.h"

namespace goal_alignment::ros_interface {
namespace {

using session::CandidateState;
using session::CandidateView;
using session::ConflictView;

bool contains(const std::vector<Literal>& fluents, const Literal& fluent) {
  return std::find(fluents.begin(), fluents.end(), fluent) != fluents.end();
}

// Speaks of one task, sentence after sentence.
class Speaker {
 public:
  explicit Speaker(const Explained& explained) : explained_(explained) { response_.known = true; }

  void speakOf(const Literal& fluent) {
    const auto& snapshot = explained_.snapshot;
    const auto candidate =
        std::find_if(snapshot.candidates.begin(), snapshot.candidates.end(),
                     [&](const CandidateView& view) { return view.fluent == fluent; });
    if (contains(snapshot.specified, fluent)) {
      say(fmt::format("You asked that {}.", clause(fluent)));
    } else if (candidate != snapshot.candidates.end()) {
      speakOf(*candidate);
    } else if (snapshot.candidates.empty() && snapshot.specified.empty()) {
      admitIgnorance();  // the models are not read yet
    } else {
      say(fmt::format("Nothing depends on whether {}: you don't expect it.", clause(fluent)));
    }
  }

  // What the outcome rests on; where there is none, why nothing is asked.
  void speakOfOutcome() {
    const std::vector<Literal>& fluents = explained_.outcome_conflict;
    const auto& conflicts = explained_.snapshot.conflicts;
    const auto conflict =
        std::find_if(conflicts.begin(), conflicts.end(), [&](const ConflictView& view) {
          return std::is_permutation(view.fluents.begin(), view.fluents.end(), fluents.begin(),
                                     fluents.end());
        });
    if (!fluents.empty() && conflict != conflicts.end()) {
      restOn(*conflict);
    } else if (explained_.snapshot.state == session::State::Done) {
      say("No question is open.");
    } else {
      admitIgnorance();
    }
  }

  const Explain::Response& response() const { return response_; }

 private:
  std::string clause(const Literal& fluent) const { return explained_.phrases.clause(fluent); }

  void say(const std::string& sentence) {
    response_.text += (response_.text.empty() ? "" : " ") + sentence;
  }

  void admitIgnorance() {
    response_.known = false;
    say("Not known yet.");
  }

  void speakOf(const CandidateView& candidate) {
    const bool answered = speakOfAnswer(candidate);
    bool any = false;
    for (const ConflictView& conflict : explained_.snapshot.conflicts) {
      // One that a NO to something else has settled is no reason any more.
      const bool counts = conflict.live || candidate.state == CandidateState::NotWanted;
      if (!counts || !contains(conflict.fluents, candidate.fluent)) continue;
      restOn(conflict);
      any = true;
    }
    if (any || answered) return;
    if (candidate.state == CandidateState::Settled || explained_.snapshot.conflicts_complete) {
      say(fmt::format("Whether it matters that {} can't change what I do.",
                      clause(candidate.fluent)));
    } else {
      admitIgnorance();
    }
  }

  bool speakOfAnswer(const CandidateView& candidate) {
    const std::string who = candidate.answered_by.empty() ? "" : " by " + candidate.answered_by;
    const std::string what = clause(candidate.fluent);
    switch (candidate.state) {
      case CandidateState::Wanted:
        say(fmt::format("It matters that {}: answered yes{}.", what, who));
        return true;
      case CandidateState::NotWanted:
        say(fmt::format("It does not matter that {}: answered no{}.", what, who));
        return true;
      case CandidateState::Unsure:
        say(fmt::format("Whether it matters that {} was answered with \"don't know\"{}.", what,
                        who));
        return true;
      default:
        return false;
    }
  }

  void restOn(const ConflictView& conflict) {
    if (!said_.insert(&conflict).second) return;
    say(explained_.phrases.reason(conflict.fluents, conflict.proven));
    response_.conflicts.push_back(toMessage(conflict, explained_.phrases));
  }

  const Explained& explained_;
  Explain::Response response_;
  std::set<const ConflictView*> said_;
};

}  // namespace

Explain::Response explainWhy(const Explained& explained, const std::vector<Literal>& fluents) {
  Speaker speaker(explained);
  const std::vector<Literal>& about = fluents.empty() ? explained.open_question : fluents;
  for (const Literal& fluent : about)
    speaker.speakOf(fluent);
  if (about.empty()) speaker.speakOfOutcome();
  return speaker.response();
}

void Explainer::show(Explained explained) {
  auto shown = std::make_shared<const Explained>(std::move(explained));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    explained_ = std::move(shown);
  }
  shown_.notify_all();
}

Explain::Response Explainer::explain(const Explain::Request& request,
                                     std::chrono::duration<double> patience) const {
  Explain::Response response;
  if (request.kind != Explain::Request::WHY) {
    const bool later =
        request.kind == Explain::Request::WHY_NOT || request.kind == Explain::Request::WHAT_IF;
    response.text = later ? "not supported yet: WHY alone is answered"
                          : fmt::format(
                                "{} is no kind of explanation: expected WHY=0, WHY_NOT=1 "
                                "or WHAT_IF=2",
                                int{request.kind});
    return response;
  }
  std::vector<Literal> fluents;
  try {
    fluents = toLiterals(request.fluents);
  } catch (const std::invalid_argument& error) {
    response.text = error.what();
    return response;
  }
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    const std::shared_ptr<const Explained> explained = explained_;
    if (!explained) {
      response.text = "No task was given yet.";
      return response;
    }
    lock.unlock();  // the solver thread must not wait for our sentences
    response = explainWhy(*explained, fluents);
    lock.lock();
    if (response.known) return response;
    const auto news = [&] { return explained_ != explained; };
    if (!shown_.wait_until(lock, deadline, news)) return response;
  }
}

}  // namespace goal_alignment::ros_interface
