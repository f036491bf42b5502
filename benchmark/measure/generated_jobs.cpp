// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include <fmt/format.h>

#include "generators/alignment_instance.h"
#include "jobs.h"

namespace goal_alignment::benchmarks {
namespace {

void align(const AlignmentInstance& instance, const DialogueOptions& dialogue,
           const MeasureLimits& limits, Record& record, const Save& save) {
  measureAlignment({instance.input(), instance.true_goal, dialogue}, limits, record, save);
}

Job familyCall(const MonotoneDnf& family, int size, std::uint64_t seed, CallKind kind) {
  const auto work = [&family, size, seed, kind](const MeasureLimits& limits, Record& record,
                                                const Save&) {
    RandomSource random(seed);
    const Models models = family.make(size, random);
    measureCall({"domain", models.domain.text()}, {"problem", models.problemText()}, kind, limits,
                record);
  };
  return {family.name, numbered(family.name + "-", size),
          kind == CallKind::Optimal ? "optimal" : "first", work};
}

Job householdJob(const std::string& suite, const HouseholdSize& size, int known, int grown,
                 std::uint64_t seed, const DialogueOptions& dialogue) {
  const auto work = [=](const MeasureLimits& limits, Record& record, const Save& save) {
    RandomSource random(seed);
    align(householdAlignment(size, known, {}, random), dialogue, limits, record, save);
  };
  return {suite, numbered("household-" + suite + "-", grown), "align", work};
}

std::string nameOf(const Truth& truth) {
  return truth.wanted < 0 ? "left-out" : truth.wanted < 0.3 ? "p02" : "p05";
}

Job homeJob(int size, const Truth& truth, std::uint64_t seed, const DialogueOptions& dialogue) {
  const auto work = [=](const MeasureLimits& limits, Record& record, const Save& save) {
    RandomSource random(seed);
    align(homeAlignment(size, truth, random), dialogue, limits, record, save);
  };
  return {"home", fmt::format("home-{}-{}", size, nameOf(truth)), "align", work};
}

}  // namespace

std::vector<Job> familyCalls(std::uint64_t seed) {
  std::vector<Job> jobs;
  for (const MonotoneDnf& family : families()) {
    for (const int size : family.sizes) {
      jobs.push_back(familyCall(family, size, seed, CallKind::First));
      if (family.solvable) jobs.push_back(familyCall(family, size, seed, CallKind::Optimal));
    }
  }
  return jobs;
}

std::vector<Job> familyAlignments(std::uint64_t seed, const DialogueOptions& dialogue) {
  std::vector<Job> jobs;
  for (const MonotoneDnf& family : families()) {
    if (!family.solvable || family.formulas) continue;
    for (const std::size_t step : {0U, 1U, 2U}) {
      const int size = family.sizes[step];
      for (const std::string differences : {"a", "aisv"}) {
        for (const double wanted : {-1.0, 0.2, 0.5}) {
          const auto work = [=, &family](const MeasureLimits& limits, Record& record,
                                         const Save& save) {
            RandomSource random(seed);
            const Models robot = family.make(size, random);
            align(alignmentOf(robot, misreadingOf(differences), {wanted}, random), dialogue, limits,
                  record, save);
          };
          jobs.push_back(
              {family.name,
               fmt::format("{}-{}-{}-{}", family.name, size, differences, nameOf({wanted})),
               "align", work});
        }
      }
    }
  }
  for (const int size : familyCalled("home").sizes)
    for (const double wanted : {-1.0, 0.2, 0.5})
      jobs.push_back(homeJob(size, {wanted}, seed, dialogue));
  return jobs;
}

std::vector<Job> householdGrowth(std::uint64_t seed, const DialogueOptions& dialogue) {
  std::vector<Job> jobs;
  HouseholdSize base;
  base.rooms = 4;
  base.cupboards = 6;
  base.stands = 6;
  base.laid = 4;
  constexpr int kKnown = 8;
  for (const int dishes : {8, 16, 32, 64, 128, 256}) {
    HouseholdSize size = base;
    size.dishes = dishes;
    jobs.push_back(householdJob("operators", size, kKnown, dishes, seed, dialogue));
    jobs.push_back(householdJob("candidates", size, dishes, dishes, seed, dialogue));
  }
  for (const int rooms : {4, 8, 16, 32, 64, 128}) {  // each has little in it: few operators
    HouseholdSize size = base;
    size.rooms = rooms;
    size.dishes = kKnown;
    jobs.push_back(householdJob("objects", size, kKnown, rooms, seed, dialogue));
  }
  jobs.push_back({"large-home", numbered("large-home-", static_cast<int>(seed)), "align",
                  [=](const MeasureLimits& limits, Record& record, const Save& save) {
                    align(largeHome(seed), dialogue, limits, record, save);
                  }});
  return jobs;
}

Record run(const Job& job, const MeasureLimits& limits) {
  Record record;
  record.set("suite", job.suite);
  record.set("task", job.task);
  record.set("kind", job.kind);
  const Record found = runInChild(
      [&](Record& mine, const Save& save) { job.work(limits, mine, save); }, limits.hard());
  for (const auto& [name, value] : found.fields())
    record.set(name, value);
  return record;
}

}  // namespace goal_alignment::benchmarks
