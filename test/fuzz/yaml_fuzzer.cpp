// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/phrasing/phrases.h"
#include "promise.h"
#include "targets.h"

namespace goal_alignment::fuzz {

namespace {

void checkSpoken(const std::string& text) {
  promise(!text.empty(), "something is said");
  promiseReadable(text);
}

/// The corpus has templates for some of these.
void phraseEverything(const phrasing::Phrases& phrases) {
  std::vector<Literal> fluents;
  for (const char* text : {"(p)", "(on a b)", "(not (on b a))", "(made-with tea a b c)", "(= a b)"})
    fluents.push_back(Literal::parse(text));
  std::vector<Literal> first;
  for (const Literal& fluent : fluents) {
    first.push_back(fluent);
    checkSpoken(phrases.clause(fluent));
    checkSpoken(phrases.action(fluent.atom));
    checkSpoken(phrases.question(first));
    checkSpoken(phrases.reason(first, fluent.negated));
  }
  for (const char* object : {"a", "b", "tea"})
    checkSpoken(phrases.object(object));
}

}  // namespace

void yaml(std::string_view bytes) {
  try {
    phraseEverything(phrasing::Phrases::fromYaml(std::string(bytes), "x.yaml"));
  } catch (const YamlError& refused) {
    const std::string message = refused.what();
    promiseMessage(message);
    promise(message.rfind("x.yaml:", 0) == 0, "an error has a place: " + message);
  }
}

}  // namespace goal_alignment::fuzz
