// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>

#include "alignment_instance.h"
#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::benchmarks {
namespace {

void writeFile(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw pddl::InputError(file.string(), {}, "can't write here");
}

template <typename Named>
std::string lines(const std::vector<Named>& named) {
  std::string text;
  for (const Named& each : named)
    text += each.text() + "\n";
  return text;
}

}  // namespace

void write(const AlignmentInstance& instance, const std::string& folder) {
  const std::filesystem::path base(folder);
  std::filesystem::create_directories(base);
  const session::Input input = instance.input();
  for (const pddl::Source* source :
       {&input.robot_domain, &input.robot_problem, &input.human_domain, &input.human_problem}) {
    writeFile(base / source->name, source->text);
  }
  writeFile(base / "human_plan.txt", lines(instance.human_plan));
  writeFile(base / "true_goal.txt", lines(instance.true_goal));
}

void write(const Models& models, const std::string& folder) {
  const std::filesystem::path base(folder);
  std::filesystem::create_directories(base);
  writeFile(base / "domain.pddl", models.domain.text());
  writeFile(base / "problem.pddl", models.problemText());
}

}  // namespace goal_alignment::benchmarks
