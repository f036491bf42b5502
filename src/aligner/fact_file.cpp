// SPDX-License-Identifier: BSD-3-Clause
#include "fact_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "file_of_robot.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/durable_file.h"

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kVersion = 1;
const std::array<const char*, 4> kModels = {"robot_domain", "robot_problem", "human_domain",
                                            "human_problem"};

std::int64_t secondsNow() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::seconds>(since_epoch).count();
}

std::string digestOf(const std::string& text) {
  return boost::uuids::to_string(boost::uuids::name_generator_sha1(boost::uuids::nil_uuid())(text));
}

json toJson(const SaidFacts::Facts& facts) {
  json list = json::array();
  for (const auto& [atom, said] : facts) {
    json item = {{"fact", Literal{atom, !said.holds}.text()}, {"order", said.order}};
    if (said.left_to_tf) item["left_to_tf"] = true;
    list.push_back(std::move(item));
  }
  return list;
}

SaidFacts::Facts factsOf(const json& list) {
  SaidFacts::Facts facts;
  for (const json& item : list) {
    const Literal fact = Literal::parse(item.at("fact").get<std::string>());
    const SaidFacts::Said said = {!fact.negated, item.at("order").get<std::uint64_t>(),
                                  item.value("left_to_tf", false)};
    if (!facts.emplace(fact.atom, said).second) {
      throw std::invalid_argument(fact.atom.text() + " is listed twice");
    }
  }
  return facts;
}

// As the files are named in the parameters.
std::string changedOf(const FactScope& now, const std::vector<std::string>& before) {
  std::string names;
  for (std::size_t i = 0; i < kModels.size(); ++i) {
    if (i < before.size() && i < now.models.size() && before[i] == now.models[i]) continue;
    names += (names.empty() ? "" : ", ") + std::string(kModels.at(i));
  }
  return names;
}

}  // namespace

FactScope FactScope::of(const session::Input& models, const std::string& world) {
  FactScope scope;
  scope.world = world;
  for (const pddl::Source* source :
       {&models.robot_domain, &models.robot_problem, &models.human_domain, &models.human_problem})
    scope.models.push_back(digestOf(source->text));
  return scope;
}

FactFile::FactFile(const std::string& folder, std::string robot, ErrorCallback complain)
    : robot_(std::move(robot)),
      file_(fileOfRobot(folder, robot_)),
      report_error_(std::move(complain)) {}

std::optional<FactFile::Kept> FactFile::open(const FactScope& scope, double expiry) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scope_ = scope;
  writing_ = expiry > 0;
  std::error_code none;
  if (!writing_ || !fs::exists(file_, none)) return std::nullopt;
  try {
    return read(scope, expiry);
  } catch (const std::exception& error) {
    report(fmt::format("the file of facts {} is damaged and {}: {}", file_,
                       ros_common::setAside(file_), error.what()));
    return std::nullopt;
  }
}

// Throws std::exception for anything that write() does not write.
std::optional<FactFile::Kept> FactFile::read(const FactScope& scope, double expiry) {
  const json entry = json::parse(pddl::readFile(file_).text);
  if (entry.at("version") != kVersion) throw std::invalid_argument("it has another version");
  if (entry.at("robot") != robot_) throw std::invalid_argument("it belongs to another robot");
  Kept kept;
  kept.facts = SaidFacts(factsOf(entry.at("facts")), factsOf(entry.at("human_facts")));
  const auto age = secondsNow() - entry.at("sec").get<std::int64_t>();
  kept.age = static_cast<double>(std::max<std::int64_t>(age, 0));  // a clock may be set back
  const std::string changed = changedOf(scope, entry.at("models").get<std::vector<std::string>>());
  const std::string which = fmt::format(
      "facts from before the restart ({} of the robot's world, {} of what the person believes; the "
      "last was set {} ago)",
      kept.facts.robot().size(), kept.facts.human().size(), spokenAge(kept.age));
  if (entry.at("world") != scope.world)
    return Kept{{}, kept.age, which + " are left out: they are of another world"};
  if (!changed.empty()) {
    report_error_(fmt::format("{} are left out, since these have changed: {}", which, changed));
    return std::nullopt;
  }
  if (kept.age > expiry) {
    report_error_(fmt::format("{} are left out: facts_expiry is {} s", which, expiry));
    return std::nullopt;
  }
  kept.line = which + " hold again";
  return kept;
}

void FactFile::setScope(const FactScope& scope) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scope_ = scope;
}

void FactFile::write(const SaidFacts& facts) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!writing_) return;
  try {
    if (facts.size() == 0) {
      fs::remove(file_);
    } else {
      const json entry = {{"version", kVersion},
                          {"robot", robot_},
                          {"world", scope_.world},
                          {"models", scope_.models},
                          {"sec", secondsNow()},
                          {"facts", toJson(facts.robot())},
                          {"human_facts", toJson(facts.human())}};
      ros_common::replaceFile(file_,
                              entry.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    }
    last_error_.clear();
  } catch (const std::exception& error) {
    report(fmt::format("the facts can't be kept for after a restart: {}", error.what()));
  }
}

std::string FactFile::lastError() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_error_;
}

// An error that repeats with every fact is reported once.
void FactFile::report(const std::string& error) {
  if (error != last_error_) report_error_(error);
  last_error_ = error;
}

std::string spokenAge(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 172800) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.0f} days", seconds / 86400);
}

}  // namespace goal_alignment::aligner
