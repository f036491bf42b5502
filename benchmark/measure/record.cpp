// SPDX-License-Identifier: BSD-3-Clause
#include "record.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <sstream>

#include "goal_alignment/pddl/exceptions.h"

namespace goal_alignment::benchmarks {
namespace {

// Long enough for names of tasks and for the figures.
constexpr std::size_t kWidest = 28;

std::string quotedForCsv(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

std::size_t widthOf(const std::string& column) {
  return column == "task" ? kWidest : std::max<std::size_t>(column.size(), 9);
}

void printCell(std::ostream& out, const std::string& column, const std::string& text) {
  const std::size_t width = widthOf(column);
  const std::string padding(width - std::min(width, text.size()), ' ');
  out << (column == "task" ? text + padding : padding + text) << "  ";
}

}  // namespace

void Record::set(const std::string& name, const std::string& value) {
  const auto known = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const auto& field) { return field.first == name; });
  if (known != fields_.end()) {
    known->second = value;
  } else {
    fields_.emplace_back(name, value);
  }
}

void Record::set(const std::string& name, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  set(name, std::string(text));
}

void Record::set(const std::string& name, std::size_t value) {
  set(name, std::to_string(value));
}

const std::string& Record::text(const std::string& name) const {
  static const std::string kNone;
  const auto known = std::find_if(fields_.begin(), fields_.end(),
                                  [&](const auto& field) { return field.first == name; });
  return known == fields_.end() ? kNone : known->second;
}

double Record::number(const std::string& name) const {
  return std::strtod(text(name).c_str(), nullptr);
}

std::string Record::serialised() const {
  std::string lines;
  for (const auto& [name, value] : fields_) {
    std::string in_one_line = value;
    std::replace(in_one_line.begin(), in_one_line.end(), '\n', ' ');
    lines.append(name).append("=").append(in_one_line).append("\n");
  }
  return lines;
}

void Record::read(const std::string& lines) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos) set(line.substr(0, equals), line.substr(equals + 1));
  }
}

std::vector<std::string> columnsOf(const std::vector<Record>& records) {
  std::vector<std::string> columns;
  for (const Record& record : records) {
    for (const auto& field : record.fields()) {
      if (std::find(columns.begin(), columns.end(), field.first) == columns.end())
        columns.push_back(field.first);
    }
  }
  return columns;
}

void writeCsv(const std::vector<Record>& records, const std::string& file) {
  std::ofstream out(file);
  const auto columns = columnsOf(records);
  for (std::size_t i = 0; i < columns.size(); ++i)
    out << (i == 0 ? "" : ",") << columns[i];
  out << '\n';
  for (const Record& record : records) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      out << (i == 0 ? "" : ",") << quotedForCsv(record.text(columns[i]));
    out << '\n';
  }
  if (!out.flush()) throw pddl::InputError(file, {}, "can't write here");
}

TablePrinter::TablePrinter(std::ostream& out, std::vector<std::string> columns)
    : out_(out), columns_(std::move(columns)) {
  for (const std::string& column : columns_)
    printCell(out_, column, column);
  out_ << std::endl;
}

void TablePrinter::print(const Record& record) {
  for (const std::string& column : columns_)
    printCell(out_, column, record.text(column));
  if (const std::string& error = record.text("error"); !error.empty()) out_ << error;
  out_ << std::endl;
}

}  // namespace goal_alignment::benchmarks
