// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cctype>
#include <string>
#include <vector>

namespace goal_alignment::cli::samples {

/// Whether the text is one element whose tags are balanced, with attributes in double quotes and no
/// stray `<` or `&`: all of XML that our drawings use.
inline bool isWellFormed(const std::string& text) {
  std::vector<std::string> open;
  std::size_t roots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '&') {
      const std::size_t end = text.find(';', i);
      if (end == std::string::npos || end - i > 5) return false;
    }
    if (text[i] != '<') {
      if (open.empty() && std::isspace(static_cast<unsigned char>(text[i])) == 0) return false;
      continue;
    }
    const std::size_t end = text.find('>', i);
    if (end == std::string::npos) return false;
    std::string tag = text.substr(i + 1, end - i - 1);
    std::size_t quotes = 0;
    for (const char letter : tag)
      quotes += letter == '"' ? 1 : 0;
    if (tag.empty() || quotes % 2 != 0 || tag.find('<') != std::string::npos) return false;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else {
      roots += open.empty() ? 1 : 0;
      if (tag.back() != '/') open.push_back(tag.substr(0, tag.find(' ')));
    }
    i = end;
  }
  return open.empty() && roots == 1;
}

}  // namespace goal_alignment::cli::samples
