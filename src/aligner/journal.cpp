// SPDX-License-Identifier: BSD-3-Clause
#include "journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/nil_generator.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/durable_file.h"

namespace goal_alignment::aligner {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using session::AnswerKind;

constexpr int kVersion = 1;
constexpr const char* kSuffix = ".json";

const char* wordOf(AnswerKind kind) {
  return kind == AnswerKind::Yes ? "yes" : kind == AnswerKind::No ? "no" : "unsure";
}

AnswerKind kindOf(const std::string& word) {
  if (word == "yes") return AnswerKind::Yes;
  if (word == "no") return AnswerKind::No;
  if (word == "unsure") return AnswerKind::Unsure;
  throw std::invalid_argument("'" + word + "' is not an answer");
}

std::string toText(const std::string& key, const std::vector<JournalAnswer>& answers) {
  json entry = {{"version", kVersion}, {"key", key}, {"answers", json::array()}};
  for (const JournalAnswer& answer : answers) {
    entry["answers"].push_back({{"fluent", answer.fluent.text()},
                                {"answer", wordOf(answer.kind)},
                                {"answered_by", answer.answered_by},
                                {"sec", answer.at.sec},
                                {"nsec", answer.at.nsec}});
  }
  // Names of people need not be UTF-8; better a replaced letter than no journal.
  return entry.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

// Throws std::exception for anything that toText() does not write.
std::vector<JournalAnswer> fromText(const std::string& text, const std::string& key) {
  const json entry = json::parse(text);
  if (entry.at("version") != kVersion) throw std::invalid_argument("it has another version");
  if (entry.at("key") != key) throw std::invalid_argument("it belongs to another task");
  std::vector<JournalAnswer> answers;
  std::set<Literal> known;
  for (const json& item : entry.at("answers")) {
    JournalAnswer answer;
    answer.fluent = Literal::parse(item.at("fluent").get<std::string>());
    answer.kind = kindOf(item.at("answer").get<std::string>());
    answer.answered_by = item.at("answered_by").get<std::string>();
    answer.at = {item.at("sec").get<std::uint32_t>(), item.at("nsec").get<std::uint32_t>()};
    if (!known.insert(answer.fluent).second) {
      throw std::invalid_argument(answer.fluent.text() + " is listed twice");
    }
    answers.push_back(std::move(answer));
  }
  return answers;
}

}  // namespace

std::string journalKey(const session::Input& input, const std::string& person,
                       const std::string& robot) {
  std::string all;
  // With its length before it no part can run into the next.
  const auto add = [&all](const std::string& part) {
    all += std::to_string(part.size()) + ":" + part;
  };
  add(robot);
  add(person);
  add(input.human_domain.text);
  add(input.human_problem.text);
  std::set<std::string> goal;
  for (const Literal& literal : input.goal)
    goal.insert(literal.text());
  add(std::to_string(goal.size()));
  for (const std::string& literal : goal)
    add(literal);
  for (const GroundName& step : input.human_plan)
    add(step.text());
  return boost::uuids::to_string(boost::uuids::name_generator_sha1(boost::uuids::nil_uuid())(all));
}

Journal::Journal(std::string folder, ErrorCallback complain)
    : folder_(std::move(folder)), report_error_(std::move(complain)) {}

std::string Journal::file() const {
  return folder_ + "/" + key_ + kSuffix;
}

std::vector<JournalAnswer> Journal::open(const std::string& key, const std::string& session_id,
                                         double expiry) {
  const std::lock_guard<std::mutex> lock(mutex_);
  key_ = key;
  session_id_ = session_id;
  writing_ = expiry > 0;
  decided_ = false;
  not_taken_.clear();
  answers_.clear();
  if (!writing_) return {};
  expire(expiry);
  answers_ = read();
  return answers_;
}

std::vector<JournalAnswer> Journal::read() {
  std::error_code none;
  if (!fs::exists(file(), none)) return {};
  try {
    return fromText(pddl::readFile(file()).text, key_);
  } catch (const std::exception& error) {
    report(fmt::format("the journal {} is damaged and {}: {}", file(), ros_common::setAside(file()),
                       error.what()));
    return {};
  }
}

void Journal::expire(double expiry) {
  const auto now = fs::file_time_type::clock::now();
  std::error_code failed;
  for (fs::directory_iterator entry(folder_, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    std::error_code unknown;
    const auto written = entry->last_write_time(unknown);
    const std::chrono::duration<double> age = now - written;
    if (unknown || age.count() <= expiry || !entry->is_regular_file(unknown)) continue;
    fs::remove(entry->path(), unknown);
  }
}

void Journal::add(const std::string& session_id, const std::vector<JournalAnswer>& answers) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (session_id != session_id_ || decided_ || answers.empty()) return;
  for (const JournalAnswer& answer : answers)
    not_taken_.insert_or_assign(answer.fluent, answer);
  replace();
}

void Journal::write(const std::vector<JournalAnswer>& answers) {
  const std::lock_guard<std::mutex> lock(mutex_);
  decided_ = false;
  answers_ = answers;
  for (const JournalAnswer& answer : answers) {
    const auto accepted = not_taken_.find(answer.fluent);
    if (accepted != not_taken_.end() && accepted->second.kind == answer.kind)
      not_taken_.erase(accepted);
  }
  replace();
}

void Journal::replace() {
  if (!writing_ || key_.empty()) return;
  std::vector<JournalAnswer> all;
  for (const JournalAnswer& answer : answers_) {
    if (not_taken_.count(answer.fluent) == 0) all.push_back(answer);
  }
  for (const auto& accepted : not_taken_)
    all.push_back(accepted.second);
  try {
    ros_common::replaceFile(file(), toText(key_, all));
    last_error_.clear();
  } catch (const std::exception& error) {
    report(fmt::format("the answers can't be written to the journal: {}", error.what()));
  }
}

void Journal::drop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  decided_ = true;
  not_taken_.clear();
  if (key_.empty()) return;
  std::error_code gone;
  fs::remove(file(), gone);
}

bool Journal::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (key_.empty()) return false;
  std::error_code gone;
  fs::remove(file(), gone);
  fs::remove(ros_common::asideOf(file()), gone);
  writing_ = false;
  return true;
}

std::string Journal::lastError() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_error_;
}

// An error that repeats with every answer is reported once.
void Journal::report(const std::string& error) {
  if (error != last_error_) report_error_(error);
  last_error_ = error;
}

}  // namespace goal_alignment::aligner
