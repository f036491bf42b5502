// SPDX-License-Identifier: BSD-3-Clause
#include "planner_output.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::pddl {

namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kStep = "step";

/// A line's place in the text, without its end.
struct Line {
  std::size_t begin = 0;
  std::size_t size = 0;
};

std::vector<Line> linesOf(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back({begin, end - begin});
    begin = end + 1;
  }
  return lines;
}

bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// What is left behind all of these characters.
std::string_view after(std::string_view text, std::string_view skipped) {
  return text.substr(std::min(text.find_first_not_of(skipped), text.size()));
}

/// `3: …` or `0.5 : …`
bool isNumbered(std::string_view text) {
  if (text.empty() || kDigits.find(text.front()) == std::string_view::npos) return false;
  return startsWith(after(after(text, "0123456789."), kBlanks), ":");
}

/// Blanks over what is no step.
class Eraser {
 public:
  explicit Eraser(std::string& text) : text_(text), lines_(linesOf(text)) {}

  void erase() {
    const auto announces = [this](const Line& line) {
      return startsWith(lowerCase(line), "ff: found legal plan as follows");
    };
    const auto plan = std::find_if(lines_.begin(), lines_.end(), announces);
    if (plan != lines_.end()) {
      for (auto line = lines_.begin(); line <= plan; ++line)
        eraseHead(*line);
    }
    for (const Line& line : lines_)
      eraseTail(line);
  }

 private:
  std::string lowerCase(const Line& line) const {
    return toLower(trimmed(std::string_view(text_).substr(line.begin, line.size)));
  }

  void blank(std::size_t begin, std::size_t size) { text_.replace(begin, size, size, ' '); }

  // Of the lines before the plan, and that which announces it.
  void eraseHead(const Line& line) {
    const std::string said = lowerCase(line);
    if (startsWith(said, "(") || isNumbered(said) || isFirstStep(said)) return;
    blank(line.begin, line.size);
  }

  static bool isFirstStep(std::string_view said) {
    return startsWith(said, kStep) && isNumbered(after(said.substr(kStep.size()), kBlanks));
  }

  // Of the plan, and of the lines behind it.
  void eraseTail(const Line& line) {
    const std::string said = lowerCase(line);
    if (isFirstStep(said)) {
      const std::string_view whole = std::string_view(text_).substr(line.begin, line.size);
      blank(line.begin + (whole.size() - after(whole, kBlanks).size()), kStep.size());
    } else if (startsWith(said, "plan cost:")) {
      blank(line.begin, line.size);
    } else if (startsWith(said, "time spent:") || (timed_ && isSeconds(said))) {
      timed_ = true;
      blank(line.begin, line.size);
    }
  }

  static bool isSeconds(std::string_view said) {
    return startsWith(after(after(said, "0123456789."), kBlanks), "seconds ");
  }

  std::string& text_;
  std::vector<Line> lines_;
  bool timed_ = false;  // `time spent:` stood above
};

}  // namespace

Source withoutChatter(Source source) {
  Eraser(source.text).erase();
  return source;
}

}  // namespace goal_alignment::pddl
