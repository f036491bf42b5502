// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

/// What is done with text from outside: by libFuzzer with texts that it thinks up, and by
/// corpus_test.cpp with those in corpus/, which every build's unit tests read again.
///
/// Each takes any bytes and returns, or throws where the core broke a promise: an exception that
/// its headers don't name goes through, any other fault is a Broken.
namespace goal_alignment::fuzz {

/// The domain's text, a line `===`, the problem's. Without that line the text is taken for both.
void pddl(std::string_view bytes);

/// A plan, a list of literals, and a single name or literal.
void plan(std::string_view bytes);

/// A phrase file, with which some fluents, questions and steps are then phrased; and rules that
/// make facts of where things are, which then are somewhere and nowhere.
void yaml(std::string_view bytes);

}  // namespace goal_alignment::fuzz
