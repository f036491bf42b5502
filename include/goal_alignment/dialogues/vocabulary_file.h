// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "goal_alignment/phrasing/vocabulary.h"

namespace goal_alignment::dialogues {

/// What dialogue nodes understand without a parameter that says otherwise.
constexpr const char* kDefaultVocabulary = "config/vocabulary/en.yaml";

/// The words of a dialogue; a relative name is one below the package's folder. Throws YamlError, or
/// what pddl::readFile() throws.
phrasing::Vocabulary vocabularyOf(const std::string& file);

}  // namespace goal_alignment::dialogues
