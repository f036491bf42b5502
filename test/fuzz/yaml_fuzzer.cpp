// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/common/yaml_reader.h"
#include "goal_alignment/phrasing/phrases.h"
#include "goal_alignment/phrasing/vocabulary.h"
#include "goal_alignment/spatial_facts/observer.h"
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

/// Every frame is somewhere, then none is.
void observeEverything(const std::shared_ptr<const spatial_facts::Rules>& rules) {
  spatial_facts::Observer observer(rules);
  std::vector<spatial_facts::Sighting> sightings(rules->pairs().size());
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    sightings[i].known = true;
    sightings[i].position.x = static_cast<double>(i);
  }
  std::set<GroundName> atoms{GroundName::parse("(p)"), GroundName::parse("(at a b)")};
  for (const bool known : {true, false}) {
    for (spatial_facts::Sighting& sighting : sightings)
      sighting.known = known;
    const spatial_facts::Observation seen = observer.observe(sightings);
    promiseReadable(seen.unknownFactsMessage());
    promise(seen.unknownFactsMessage().empty() == seen.unknown().empty(),
            "what is unknown is lamented");
    for (const spatial_facts::Doubt& doubt : seen.doubts) {
      for (const GroundName& atom : doubt.atoms)
        promise(seen.holds.count(atom) == 0, "an atom is true or in doubt");
    }
    seen.overlay(atoms);
  }
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
void readOrRefuse(Read read) {
  try {
    read();
  } catch (const YamlError& refused) {
    const std::string message = refused.what();
    promiseMessage(message);
    promise(message.rfind("x.yaml:", 0) == 0, "an error has a place: " + message);
  }
}

}  // namespace

void yaml(std::string_view bytes) {
  const std::string text(bytes);
  readOrRefuse([&] { phraseEverything(phrasing::Phrases::fromYaml(text, "x.yaml")); });
  readOrRefuse([&] { observeEverything(spatial_facts::Rules::fromYaml(text, "x.yaml")); });
  readOrRefuse([&] { understandEverything(phrasing::Vocabulary::fromYaml(text, "x.yaml")); });
}

}  // namespace goal_alignment::fuzz
