// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "goal_alignment/cli/alignment_options.h"
#include "goal_alignment/cli/commands.h"
#include "goal_alignment/cli/instance.h"
#include "goal_alignment/cli/interrupt.h"
#include "goal_alignment/cli/json_output.h"
#include "goal_alignment/phrasing/phrases.h"

namespace goal_alignment::cli {

using session::AnswerKind;
using session::QuestionView;
using session::Session;

namespace {

struct AlignArguments {
  std::string folder;
  InstanceFiles files;
  std::string true_goal;
  bool interactive = false;
  bool json = false;
  AlignmentWords words;
};

/// Asks on stderr, reads from stdin until the answer is one; nothing at the end of input.
std::optional<AnswerKind> askOnTerminal(const QuestionView& question) {
  const phrasing::Phrases phrases;
  std::cerr << phrases.reason(question.conflict, question.conflict_proven) << '\n'
            << phrases.question(question.fluents) << " [yes/no/?, decline] " << std::flush;
  for (std::string line; std::getline(std::cin, line);) {
    const std::string word = toLower(line);
    if (word == "y" || word == "yes") return AnswerKind::Yes;
    if (word == "n" || word == "no") return AnswerKind::No;
    if (word == "?" || word == "don't know" || word == "unsure") return AnswerKind::Unsure;
    if (word == "decline") return AnswerKind::Decline;
    std::cerr << "please answer yes, no, ? (don't know) or decline: " << std::flush;
  }
  return std::nullopt;
}

class Alignment {
 public:
  explicit Alignment(const AlignArguments& arguments)
      : arguments_(arguments), session_(arguments.words.options()) {}

  int run() {
    InstanceFiles files =
        arguments_.folder.empty() ? arguments_.files : InstanceFiles::of(arguments_.folder);
    if (!arguments_.true_goal.empty()) files.true_goal = arguments_.true_goal;
    if (!arguments_.interactive && !files.true_goal.empty()) oracle_.emplace(files.true_goal);
    session_.begin(readInput(files));
    const InterruptGuard guard(session_);
    while (session_.step() != session::State::Done) {
      if (session_.state() == session::State::AwaitingAnswer) answer(*session_.question());
    }
    report();
    return session::exitStatus(session_.outcome().code);
  }

 private:
  void answer(const QuestionView& question) {
    std::optional<AnswerKind> kind;
    if (oracle_) {
      kind = oracle_->answer(question.fluents.front());
    } else if (arguments_.interactive) {
      kind = askOnTerminal(question);
    }
    if (kind) {
      session_.answer(question.fluents, *kind, oracle_ ? "true goal" : "terminal");
    } else if (session_.step() != session::State::Done) {  // Ctrl-C ends the read, too
      session_.giveUpWaiting("there is nobody to answer whether " +
                             session_.spelling(question.fluents.front()) + " matters");
    }
  }

  void report() const {
    if (arguments_.json) {
      std::cout << toJson(session_).dump(2) << '\n';
      return;
    }
    for (const session::QuestionRecord& record : session_.questions()) {
      const char* const words[] = {"no", "yes", "don't know", "declined"};
      std::cout << "; asked " << session_.spelling(record.fluents.front()) << ": "
                << words[static_cast<int>(record.answer)] << '\n';
    }
    const session::Outcome& outcome = session_.outcome();
    std::cout << "; " << session::outcomeWord(outcome.code) << ": " << outcome.message << '\n';
    for (const GroundName& step : outcome.plan.steps)
      std::cout << step.text() << '\n';
  }

  const AlignArguments& arguments_;
  Session session_;
  std::optional<ScriptedOracle> oracle_;
};

void requireFiles(const AlignArguments& arguments) {
  const InstanceFiles& files = arguments.files;
  const bool any = !files.robot_domain.empty() || !files.robot_problem.empty() ||
                   !files.human_domain.empty() || !files.human_problem.empty() ||
                   !files.human_plan.empty();
  const bool all = !files.robot_domain.empty() && !files.robot_problem.empty() &&
                   !files.human_domain.empty() && !files.human_problem.empty() &&
                   !files.human_plan.empty();
  if (arguments.folder.empty() != all || (any && !all)) {
    throw CLI::ValidationError(
        "align",
        "give either an instance folder or all of --robot-domain, --robot-problem, "
        "--human-domain, --human-problem and --human-plan");
  }
}

}  // namespace

void addAlignCommand(CLI::App& app, Run& run) {
  auto arguments = std::make_shared<AlignArguments>();
  CLI::App* command = app.add_subcommand("align", "find the true goal and plan for it");
  command->add_option("DIR", arguments->folder, "instance folder");
  command->add_option("--robot-domain", arguments->files.robot_domain);
  command->add_option("--robot-problem", arguments->files.robot_problem);
  command->add_option("--human-domain", arguments->files.human_domain);
  command->add_option("--human-problem", arguments->files.human_problem);
  command->add_option("--human-plan", arguments->files.human_plan);
  auto* true_goal =
      command->add_option("--true-goal", arguments->true_goal, "answers the questions");
  command->add_flag("--interactive", arguments->interactive, "you answer")->excludes(true_goal);
  command->add_option("--policy", arguments->words.policy,
                      "auto, optimal, ratio, paper or ask-all");
  arguments->words.add(*command);
  command->add_flag("--json", arguments->json);
  command->callback([arguments, &run] {
    requireFiles(*arguments);
    run = [arguments] {
      try {
        return Alignment(*arguments).run();
      } catch (const Exception& exception) {
        if (!arguments->json) throw;
        const session::Outcome outcome = session::outcomeOf(exception);
        std::cout << toJson(outcome).dump(2) << '\n';
        return session::exitStatus(outcome.code);
      }
    };
  });
}

}  // namespace goal_alignment::cli
