// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "bench_row.h"

namespace goal_alignment::cli {

/// The table for people: rows as they come, what they come to at the end.
class BenchTable {
 public:
  /// `widest` is the length of the longest instance's name.
  BenchTable(std::ostream& out, std::size_t widest);
  void print(const std::vector<Row>& rows);
  /// One line a policy and truth, over the instances that ran.
  void printSummary(const std::vector<Row>& rows);

 private:
  std::ostream& out_;
  std::size_t width_;
  bool begun_ = false;
};

/// The geometric mean of the policy's mean questions over those of `paper`, over the instances
/// where both asked something, and how many those are. `policy`'s rows need not be next to it.
struct PaperRatio {
  double geometric_mean = 0;
  std::size_t instances = 0;
};
PaperRatio ratioToPaper(const std::vector<Row>& rows, const std::string& policy,
                        const std::string& truth);

/// RFC 4180, the fields of toJson(Row); one that does not apply is empty. Throws pddl::InputError.
void writeCsv(const std::vector<Row>& rows, const std::string& file);

/// Beside the CSV: `<stem>_questions.svg` and `<stem>_time.svg`. Throws pddl::InputError.
void writePlots(const std::vector<Row>& rows, const std::string& csv_file);

}  // namespace goal_alignment::cli
