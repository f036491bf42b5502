// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace goal_alignment::phrasing {

/// The files of config/phrases by language, as they were when the library was built: to speak, it
/// needs no file.
const std::map<std::string, std::string>& shippedLanguageFiles();

}  // namespace goal_alignment::phrasing
