// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace goal_alignment::benchmarks {

/// One row of figures: names and values, in the order in which they were set. Values are texts, so
/// that a row goes through a pipe and into a table as it is.
class Record {
 public:
  void set(const std::string& name, const std::string& value);
  void set(const std::string& name, double value);
  void set(const std::string& name, std::size_t value);

  /// The empty text where there is none.
  const std::string& text(const std::string& name) const;
  /// 0 where there is none or no number.
  double number(const std::string& name) const;

  const std::vector<std::pair<std::string, std::string>>& fields() const { return fields_; }

  /// Lines `name=value`; line ends within a value become spaces.
  std::string serialised() const;
  /// Adds the fields that serialised() wrote.
  void read(const std::string& lines);

 private:
  std::vector<std::pair<std::string, std::string>> fields_;
};

/// The names that occur in any of the records, in order of their first occurrence.
std::vector<std::string> columnsOf(const std::vector<Record>& records);

/// RFC 4180. Throws pddl::InputError where the file can't be written.
void writeCsv(const std::vector<Record>& records, const std::string& file);

/// A table for people: each record gets a line as soon as it is printed.
class TablePrinter {
 public:
  TablePrinter(std::ostream& out, std::vector<std::string> columns);
  void print(const Record& record);

 private:
  std::ostream& out_;
  std::vector<std::string> columns_;
};

}  // namespace goal_alignment::benchmarks
