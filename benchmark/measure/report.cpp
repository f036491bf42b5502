// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace goal_alignment::benchmarks {
namespace {

using Records = std::vector<Record>;
using Groups = std::map<std::pair<std::string, std::string>, Records>;  // by kind and suite

struct Checks {
  double all = 0;
  double unknown = 0;
};

Checks checksOf(const Records& records) {
  Checks sum;
  for (const Record& record : records) {
    const bool said = !record.text("checks").empty();
    sum.all += said ? record.number("checks") : 1;
    sum.unknown += said ? record.number("checks_unknown") : 1;
  }
  return sum;
}

double sum(const Records& records, const std::string& field) {
  double result = 0;
  for (const Record& record : records)
    result += record.number(field);
  return result;
}

double largest(const Records& records, const std::string& field) {
  double result = 0;
  for (const Record& record : records)
    result = std::max(result, record.number(field));
  return result;
}

Groups grouped(const Records& records) {
  Groups groups;
  for (const Record& record : records)
    groups[{record.text("kind"), record.text("suite")}].push_back(record);
  return groups;
}

// The share of the total that each phase took, the dear ones first.
std::string split(const Records& records) {
  const double total = sum(records, "total");
  std::vector<std::pair<double, std::string>> shares;
  for (const char* phase :
       {"parse", "ground", "mutexes", "search", "belief", "conflict_s", "question_s", "plan"}) {
    const double share = total > 0 ? 100 * sum(records, phase) / total : 0;
    if (share >= 1) shares.emplace_back(share, phase);
  }
  std::sort(shares.rbegin(), shares.rend());
  std::string text;
  for (const auto& [share, phase] : shares)
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", phase, share);
  return text;
}

std::string percent(double part, double whole) {
  return whole > 0 ? fmt::format("{:.1f} %", 100 * part / whole) : "–";
}

std::string ratio(double part, double whole) {
  return whole > 0 ? fmt::format("{:.2f}", part / whole) : "–";
}

std::string row(const std::string& kind, const std::string& suite, const Records& records) {
  const auto finished = std::count_if(records.begin(), records.end(), isFinished);
  const Checks checks = checksOf(records);
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {:.0f} |\n", kind, suite,
                     records.size(), finished, percent(checks.unknown, checks.all),
                     ratio(sum(records, "questions"), sum(records, "candidates")),
                     ratio(largest(records, "longest_step"), largest(records, "first_question")),
                     split(records), largest(records, "peak_mib"));
}

// By how much the largest exceeds the smallest within the finished records; 0 where there are none.
double factor(const Records& records, const std::string& field) {
  double least = std::numeric_limits<double>::max();
  double most = 0;
  for (const Record& record : records) {
    const double value = record.number(field);
    if (!isFinished(record) || value <= 0) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return most > 0 ? most / least : 0;
}

// What a suite is about: that which its name says grows, else the operators.
std::string grownIn(const std::string& suite) {
  return suite == "objects" || suite == "candidates" ? suite : "operators";
}

std::string growthRow(const std::string& kind, const std::string& suite, const Records& records) {
  constexpr int kFewest = 3;        // through two points there is always a line
  constexpr double kMinSpread = 3;  // tasks of one size say nothing of growth
  const std::string x = grownIn(suite);
  const auto finished = std::count_if(records.begin(), records.end(), isFinished);
  const double exponent = growthExponent(records, x, "total");
  const double spread = factor(records, x);
  if (finished < kFewest || spread < kMinSpread || std::isnan(exponent)) return {};
  return fmt::format("| {} | {} | {} | ×{:.3g} | ×{:.3g} | {:.2f} |\n", kind, suite, x, spread,
                     factor(records, "total"), exponent);
}

std::string headline(const std::string& of, Records records, bool alignments) {
  records.erase(std::remove_if(records.begin(), records.end(),
                               [&](const Record& record) {
                                 return (record.text("kind") == "align") != alignments;
                               }),
                records.end());
  if (records.empty()) return {};
  const Checks checks = checksOf(records);
  const auto finished = std::count_if(records.begin(), records.end(), isFinished);
  return fmt::format(
      "Checks left unknown, {}: **{}** ({:.0f} of {:.0f}); finished: {} of {} tasks.\n\n", of,
      percent(checks.unknown, checks.all), checks.unknown, checks.all, finished, records.size());
}

}  // namespace

bool isFinished(const Record& record) {
  const std::string& status = record.text("status");
  return status == "solved" || status == "unsolvable" || status == "plan_found" ||
         status == "no_plan";
}

double shareOfChecksUnknown(const Records& records) {
  const Checks checks = checksOf(records);
  return checks.all > 0 ? checks.unknown / checks.all : 0;
}

double growthExponent(const Records& records, const std::string& x, const std::string& y) {
  double n = 0;
  double sum_x = 0;
  double sum_y = 0;
  double sum_xx = 0;
  double sum_xy = 0;
  for (const Record& record : records) {
    if (!isFinished(record) || record.number(x) <= 0 || record.number(y) <= 0) continue;
    const double log_x = std::log(record.number(x));
    const double log_y = std::log(record.number(y));
    ++n;
    sum_x += log_x;
    sum_y += log_y;
    sum_xx += log_x * log_x;
    sum_xy += log_x * log_y;
  }
  const double spread = n * sum_xx - sum_x * sum_x;
  if (spread < 1e-9) return std::numeric_limits<double>::quiet_NaN();
  return (n * sum_xy - sum_x * sum_y) / spread;
}

std::string summary(const Records& records) {
  std::string text =
      headline("alignments", records, true) + headline("single calls", records, false);
  text +=
      "| kind | suite | tasks | finished | checks unknown | questions / candidates | longest step "
      "/ "
      "first question | where the time goes | peak MiB |\n|---|---|---|---|---|---|---|---|---|\n";
  const Groups groups = grouped(records);
  for (const auto& [name, group] : groups)
    text += row(name.first, name.second, group);
  text +=
      "\nGrowth, over the finished tasks of each suite: time ~ x^exponent.\n\n"
      "| kind | suite | x | x grows | time grows | exponent |\n|---|---|---|---|---|---|\n";
  for (const auto& [name, group] : groups)
    text += growthRow(name.first, name.second, group);
  return text;
}

}  // namespace goal_alignment::benchmarks
