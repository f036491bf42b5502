// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "goal_alignment/cli/instance.h"
#include "goal_alignment/pddl/exceptions.h"
#include "goal_alignment/pddl/parser.h"
#include "jobs.h"

namespace goal_alignment::benchmarks {
namespace {

using Path = std::filesystem::path;

bool isDomain(const Path& file) {
  return file.stem().string().find("domain") != std::string::npos;
}

// The domain of a problem, or nothing.
Path domainOf(const Path& problem) {
  std::string stem = problem.stem().string();
  const Path folder = problem.parent_path();
  std::vector<std::string> names = {stem + "-domain.pddl", "domain-" + stem + ".pddl"};
  if (const std::size_t word = stem.find("-problem"); word != std::string::npos) {
    stem.erase(word);
    names.push_back(stem + "-domain.pddl");
    names.push_back("domain-" + stem + ".pddl");
  }
  names.emplace_back("domain.pddl");
  for (const std::string& name : names) {
    if (std::filesystem::exists(folder / name)) return folder / name;
  }
  return {};
}

Job callJob(const std::string& suite, const std::string& name, const Path& domain,
            const Path& problem, CallKind kind) {
  return {suite, name, kind == CallKind::Optimal ? "optimal" : "first",
          [=](const MeasureLimits& limits, Record& record, const Save&) {
            measureCall(pddl::readFile(domain.string()), pddl::readFile(problem.string()), kind,
                        limits, record);
          }};
}

Job alignmentJob(const std::string& suite, const std::string& name, const Path& folder,
                 const DialogueOptions& dialogue) {
  return {suite, name, "align", [=](const MeasureLimits& limits, Record& record, const Save& save) {
            const auto files = cli::InstanceFiles::of(folder.string());
            AlignmentWork work = {cli::readInput(files), {}, dialogue};
            if (!files.true_goal.empty())
              work.true_goal = pddl::parseLiterals(pddl::readFile(files.true_goal));
            measureAlignment(work, limits, record, save);
          }};
}

}  // namespace

std::vector<Job> jobsBelow(const std::string& path, const DialogueOptions& dialogue) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error))
    throw pddl::InputError(path, {}, "expected a folder");
  const Path base = std::filesystem::canonical(path);
  const std::vector<Path> alignments = cli::instanceFoldersBelow(base);
  std::map<Path, std::vector<Path>> texts;  // by folder
  for (const Path& folder : alignments)
    texts[folder];
  for (const auto& entry : std::filesystem::recursive_directory_iterator(base)) {
    if (entry.path().extension() == ".pddl") texts[entry.path().parent_path()].push_back(entry);
  }
  std::vector<Job> jobs;
  for (auto& [folder, files] : texts) {
    const std::string below = folder.lexically_relative(base).generic_string();
    const std::string root = base.filename().string();
    const std::string suite =
        below.find('/') == std::string::npos ? root : below.substr(0, below.find('/'));
    const std::string name = below == "." ? root : below;
    if (std::binary_search(alignments.begin(), alignments.end(), folder)) {
      jobs.push_back(alignmentJob(suite, name, folder, dialogue));
      continue;
    }
    std::sort(files.begin(), files.end());
    for (const Path& problem : files) {
      const Path domain = isDomain(problem) ? Path() : domainOf(problem);
      if (domain.empty()) continue;
      const std::string stem = problem.stem().string();
      const std::string task = stem == "problem" ? name : fmt::format("{}/{}", name, stem);
      jobs.push_back(callJob(suite, task, domain, problem, CallKind::First));
      jobs.push_back(callJob(suite, task, domain, problem, CallKind::Optimal));
    }
  }
  if (jobs.empty()) throw pddl::InputError(path, {}, "no planning task and no instance folder");
  return jobs;
}

}  // namespace goal_alignment::benchmarks
