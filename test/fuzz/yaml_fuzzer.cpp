// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vector>

#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/phrasing/vocabulary.h"
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

void understandEverything(const phrasing::Vocabulary& vocabulary) {
  for (const char* said : {"", "yes", "no", "the first one and the towel", "\xff'1 2"}) {
    const auto heard = vocabulary.understand(said, {"the towel", "the shirt"});
    if (!heard) continue;
    for (const std::size_t chosen : heard->reply.chosen)
      promise(chosen < 2, "what is chosen is offered");
  }
  promiseReadable(vocabulary.numbered(0, "it"));
}

template <typename Read>
void refuseWithPlace(Read read) {
  try {
    read();
  } catch (const phrasing::PhraseError& refused) {
    const std::string message = refused.what();
    promiseMessage(message);
    promise(message.rfind("x.yaml:", 0) == 0, "an error has a place: " + message);
  }
}

}  // namespace

void yaml(std::string_view bytes) {
  const std::string text(bytes);
  refuseWithPlace([&] { phraseEverything(phrasing::Phrases::fromYaml(text, "x.yaml")); });
  refuseWithPlace([&] { understandEverything(phrasing::Vocabulary::fromYaml(text, "x.yaml")); });
}

}  // namespace goal_alignment::fuzz
