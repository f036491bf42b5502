// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "goal_alignment/pddl/exceptions.h"
#include "report.h"
#include "svg_plot.h"

namespace goal_alignment::benchmarks {
namespace {

using Records = std::vector<Record>;

void writePlot(const Plot& plot, const std::filesystem::path& file) {
  bool empty = true;
  for (const Series& series : plot.series)
    empty = empty && series.points.empty();
  if (empty) return;
  std::ofstream out(file);
  out << svg(plot);
  if (!out.flush()) throw pddl::InputError(file.string(), {}, "can't write here");
}

// One series a suite: the whole time.
std::vector<Series> bySuite(const Records& records, const std::string& kind, const std::string& x) {
  std::map<std::string, Series> series;
  for (const Record& record : records) {
    if (record.text("kind") != kind || !isFinished(record) || record.number(x) <= 0) continue;
    Series& own = series[record.text("suite")];
    own.name = record.text("suite");
    own.points.emplace_back(record.number(x), record.number("total"));
  }
  std::vector<Series> all;
  all.reserve(series.size());
  for (auto& [suite, own] : series)
    all.push_back(std::move(own));
  return all;
}

// One series a phase, of the suite in which x grows alone.
std::vector<Series> byPhase(const Records& records, const std::string& x) {
  std::vector<Series> all = {{"total", {}},     {"first_question", {}}, {"longest_step", {}},
                             {"ground", {}},    {"belief", {}},         {"conflict_s", {}},
                             {"question_s", {}}};
  for (const Record& record : records) {
    if (record.text("suite") != x || record.text("kind") != "align" || !isFinished(record))
      continue;
    for (Series& series : all)
      series.points.emplace_back(record.number(x), record.number(series.name));
  }
  return all;
}

}  // namespace

void writePlots(const Records& records, const std::string& folder) {
  const std::filesystem::path base(folder);
  std::filesystem::create_directories(base);
  for (const std::string x : {"objects", "operators", "candidates"}) {
    for (const std::string kind : {"first", "optimal"}) {
      writePlot({fmt::format("{} plan: time by {}", kind, x), x, "seconds",
                 bySuite(records, kind, x), true},
                base / (fmt::format("calls_{}_{}.svg", kind, x)));
    }
    writePlot({"alignment: time by " + x, x, "seconds", bySuite(records, "align", x), false},
              base / (fmt::format("alignments_{}.svg", x)));
    writePlot({fmt::format("alignment: time as only the {} grow", x), x, "seconds",
               byPhase(records, x), true},
              base / (fmt::format("growth_{}.svg", x)));
  }
}

}  // namespace goal_alignment::benchmarks
