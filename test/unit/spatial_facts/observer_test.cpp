// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/spatial_facts/observer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "samples.h"

namespace goal_alignment::spatial_facts {
namespace {

using samples::aged;
using samples::at;
using samples::location;
using samples::missing;
using samples::rules;
using samples::texts;
using Texts = std::set<std::string>;

Texts seenAt(Observer& observer, double x, double y = 0) {
  return texts(observer.observe({at(x, y)}).holds);
}

TEST(Observer, SaysWhereTheThingIs) {
  Observer observer(location());
  EXPECT_EQ(seenAt(observer, 1), Texts{"(at robot kitchen)"});
  EXPECT_EQ(seenAt(observer, 7), Texts{"(at robot hall)"});
}

TEST(Observer, LeavesARegionOnlyBeyondTheMargin) {
  Observer observer(location());
  seenAt(observer, 3.9);
  EXPECT_EQ(seenAt(observer, 4.15), Texts{"(at robot kitchen)"}) << "the hall already, but near";
  EXPECT_EQ(seenAt(observer, 4.25), Texts{"(at robot hall)"});
  EXPECT_EQ(seenAt(observer, 3.85), Texts{"(at robot hall)"}) << "and back again";
  EXPECT_EQ(seenAt(observer, 3.75), Texts{"(at robot kitchen)"});
}

TEST(Observer, WhereNothingIsOneOfFourThingsHolds) {
  Observer unknown(location());
  const Observation lost = unknown.observe({at(2, 9)});
  EXPECT_TRUE(lost.holds.empty());
  EXPECT_EQ(lost.unknown().size(), 2U);
  EXPECT_EQ(lost.unknownFactsMessage(),
            "nobody can tell (at robot kitchen), (at robot hall): robot (frame base_link) is in "
            "none of kitchen, hall; the nearest, kitchen, is 7.00 m away");

  Observer nothing(location("nothing"));
  EXPECT_TRUE(nothing.observe({at(2, 9)}).holds.empty());
  EXPECT_TRUE(nothing.observe({at(2, 9)}).unknown().empty());
  Observer nearest(location("nearest"));
  EXPECT_EQ(seenAt(nearest, 8, 9), Texts{"(at robot hall)"});
  Observer garden(location("garden"));
  EXPECT_EQ(seenAt(garden, 8, 9), Texts{"(at robot garden)"});
  EXPECT_EQ(seenAt(garden, 5), Texts{"(at robot hall)"});
}

TEST(Observer, TakesTheRegionItIsDeepestIn) {
  Observer observer(rules(R"(
  nook: {box: {xyz: [1, 0, 0], size: [2, 2]}}
rules:
  - {fact: '(at robot ?room)', when: "robot in ?room", for: {room: [nook, kitchen]}, exactly_one: room}
)"));
  EXPECT_EQ(texts(observer.observe({at(1.6), at(1.6)}).holds), Texts{"(at robot kitchen)"});
  Observer fresh(observer.rules());
  EXPECT_EQ(texts(fresh.observe({at(0.5)}).holds), Texts{"(at robot nook)"})
      << "both are as deep: the first";
}

TEST(Observer, NamesFrameAgeAndAtomsOfWhatItCannotTell) {
  Observer observer(location());
  const auto unknownFactsMessage = [&](const Sighting& sighting) {
    const Observation seen = observer.observe({sighting});
    EXPECT_TRUE(seen.holds.empty());
    EXPECT_EQ(seen.unknown().size(), 2U);
    return seen.unknownFactsMessage();
  };
  EXPECT_EQ(unknownFactsMessage(missing("no such frame")),
            "nobody can tell (at robot kitchen), (at robot hall): where frame base_link is in map "
            "is not known: no such frame");
  EXPECT_EQ(unknownFactsMessage(aged(at(1), 12.34)),
            "nobody can tell (at robot kitchen), (at robot hall): where frame base_link is in map "
            "was last known 12.3 s ago, more than 2 s");
  EXPECT_NE(unknownFactsMessage(aged(at(1), -60)).find("60.0 s in the future"), std::string::npos);
  EXPECT_NE(unknownFactsMessage(at(std::numeric_limits<double>::quiet_NaN())).find("no number"),
            std::string::npos);
  EXPECT_EQ(texts(observer.observe({aged(at(1), 2)}).holds), Texts{"(at robot kitchen)"});
  EXPECT_EQ(texts(observer.observe({aged(at(1), -0.5)}).holds), Texts{"(at robot kitchen)"})
      << "localisation may date its transforms ahead";
}

TEST(Observer, RemembersAcrossATimeWithoutSight) {
  Observer observer(location());
  seenAt(observer, 3.9);
  observer.observe({missing("gone")});
  EXPECT_EQ(seenAt(observer, 4.1), Texts{"(at robot kitchen)"});
}

std::set<GroundName> atoms(const Texts& given) {
  std::set<GroundName> result;
  for (const std::string& text : given)
    result.insert(GroundName::parse(text));
  return result;
}

Texts overlaid(const Observation& seen, const Texts& given) {
  std::set<GroundName> state = atoms(given);
  seen.overlay(state);
  return texts(state);
}

TEST(Observer, ReplacesEveryAtomThatARuleOwns) {
  Observer observer(location());
  const Texts file{"(at robot hall)", "(at robot cellar)", "(at cup hall)", "(lit hall)",
                   "(at robot)"};
  EXPECT_EQ(overlaid(observer.observe({at(1)}), file),
            (Texts{"(at robot kitchen)", "(at cup hall)", "(lit hall)", "(at robot)"}));
  EXPECT_EQ(overlaid(observer.observe({missing("gone")}), file),
            (Texts{"(at cup hall)", "(lit hall)", "(at robot)"}))
      << "unknown is neither true";
  EXPECT_EQ(overlaid(Observation{}, file), file) << "no rules";
}

TEST(Observer, TrustsTheFileWhereTheRuleSaysSo) {
  Observer observer(location("unknown", "    unknown: trust_file\n"));
  const Texts file{"(at robot cellar)", "(at cup hall)"};
  const Observation blind = observer.observe({missing("gone")});
  EXPECT_EQ(overlaid(blind, file), file);
  EXPECT_TRUE(blind.unknown().empty());
  EXPECT_TRUE(blind.unknownFactsMessage().empty());
  EXPECT_EQ(overlaid(observer.observe({at(1)}), file),
            (Texts{"(at robot kitchen)", "(at cup hall)"}));
}

TEST(Observer, TellsDistances) {
  Observer observer(
      rules("rules:\n  - {fact: '(near cup ?who)', when: 'cup within 1.5 m of ?who', "
            "for: {who: [robot, ann]}}\n"));
  ASSERT_EQ(observer.rules()->pairs().size(), 2U);
  EXPECT_EQ(observer.rules()->pairs()[0].in, "base_link");
  EXPECT_EQ(observer.rules()->pairs()[0].of, "cup_link");
  EXPECT_EQ(texts(observer.observe({at(1, 1), at(3)}).holds), Texts{"(near cup robot)"});
  EXPECT_EQ(texts(observer.observe({at(1.69), at(0, 0, 1.4)}).holds),
            (Texts{"(near cup robot)", "(near cup ann)"}))
      << "within the margin of the first";
  const Observation half = observer.observe({at(9), missing("gone")});
  EXPECT_TRUE(half.holds.empty());
  ASSERT_EQ(half.unknown().size(), 1U);
  EXPECT_EQ(half.unknown()[0].text(), "(near cup ann)");
}

TEST(Observer, TellsDistancesOnTheFloor) {
  Observer observer(
      rules("rules:\n  - {fact: (met ann), when: robot within 1 of ann, horizontal: "
            "true}\n"));
  ASSERT_EQ(observer.rules()->pairs().size(), 2U);
  for (const FramePair& pair : observer.rules()->pairs())
    EXPECT_EQ(pair.in, "map");
  EXPECT_EQ(texts(observer.observe({at(5, 5, 0), at(5, 5.9, 1.7)}).holds), Texts{"(met ann)"});
  EXPECT_TRUE(observer.observe({at(5, 5, 0), at(5, 9, 0)}).holds.empty());
  EXPECT_EQ(observer.observe({at(5), missing("gone")}).unknown().size(), 1U);
}

TEST(Observer, TellsTheOpposites) {
  Observer observer(
      rules("rules:\n  - {fact: '(away ?who)', when: '?who outside kitchen', for: {who: "
            "robot}}\n  - {fact: (alone), when: robot beyond 2 of ann}\n"));
  EXPECT_EQ(texts(observer.observe({at(9), at(3)}).holds), (Texts{"(alone)", "(away robot)"}));
  EXPECT_TRUE(observer.observe({at(1), at(1)}).holds.empty());
  EXPECT_TRUE(observer.observe({at(4.1), at(2.1)}).holds.empty()) << "within the margin";
  EXPECT_EQ(texts(observer.observe({at(4.3), at(2.3)}).holds), (Texts{"(alone)", "(away robot)"}));
}

TEST(Observer, AnyOfTheThingsThatTheFactDoesNotNameWillDo) {
  Observer observer(
      rules("rules:\n  - {fact: (company), when: 'robot within 2 of ?who', for: {who: "
            "[ann, cup]}}\n"));
  EXPECT_EQ(texts(observer.observe({at(9), at(1)}).holds), Texts{"(company)"});
  EXPECT_EQ(texts(observer.observe({missing("gone"), at(1)}).holds), Texts{"(company)"})
      << "one is enough";
  const Observation unsure = observer.observe({missing("gone"), at(9)});
  EXPECT_EQ(unsure.unknown().size(), 1U);
  EXPECT_TRUE(observer.observe({at(9), at(9)}).doubts.empty());
}

TEST(Observer, SummarisesManyDoubts) {
  Observer observer(rules(R"(
rules:
  - {fact: '(in-sight ?a ?b)', when: '?a within 3 of ?b', for: {a: [robot, cup, ann], b: [robot, cup, ann]}}
)"));
  const std::vector<Sighting> none(observer.rules()->pairs().size(), missing("gone"));
  const Observation seen = observer.observe(none);
  EXPECT_EQ(seen.unknown().size(), 6U) << "nothing is compared with itself";
  EXPECT_NE(seen.unknownFactsMessage().find("; nor 3 more"), std::string::npos)
      << seen.unknownFactsMessage();
  EXPECT_LT(seen.unknownFactsMessage().size(), 500U);
}

TEST(Observer, NoticesWhatHasChanged) {
  Observer observer(location());
  const Observation before = observer.observe({at(1)});
  EXPECT_TRUE(before.tellsTheSame(observer.observe({at(2)})));
  EXPECT_FALSE(before.tellsTheSame(observer.observe({at(6)})));
  EXPECT_FALSE(before.tellsTheSame(observer.observe({missing("gone")})));
  EXPECT_FALSE(before.tellsTheSame(Observation{}));
  EXPECT_TRUE(Observation{}.tellsTheSame(Observation{}));
}

// Any walk: what is within the margin of where it was stays there; and there is always one place.
RC_GTEST_PROP(Observer, NeverFlipsWithinTheMargin, ()) {
  Observer observer(location("nearest"));
  const auto walk = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-3000, 11000));
  std::string before;
  for (const int millimetres : walk) {
    const double x = millimetres / 1000.0;
    const Texts now = seenAt(observer, x);
    RC_ASSERT(now.size() == 1U);
    const bool deep_in_kitchen = x >= 0 && x < 4 - 0.201;
    const bool deep_in_hall = x > 4 + 0.201 && x <= 8;
    if (deep_in_kitchen) RC_ASSERT(*now.begin() == "(at robot kitchen)");
    if (deep_in_hall) RC_ASSERT(*now.begin() == "(at robot hall)");
    const bool on_the_border = x > 4 - 0.199 && x < 4 + 0.199;
    if (on_the_border && !before.empty()) RC_ASSERT(*now.begin() == before);
    before = *now.begin();
  }
}

// The same for one that is true or false: between the border and the margin nothing changes.
RC_GTEST_PROP(Observer, ChangesABooleanFactOnlyAtItsBorders, ()) {
  const bool opposite = *rc::gen::arbitrary<bool>();
  Observer observer(rules(std::string("rules:\n  - {fact: (inside), when: robot ") +
                          (opposite ? "outside" : "in") + " kitchen}\n"));
  bool inside = false;
  for (const int millimetres :
       *rc::gen::container<std::vector<int>>(rc::gen::inRange(-1000, 5000))) {
    const double x = millimetres / 1000.0;
    const bool now = (seenAt(observer, x).size() == 1) != opposite;
    if (x >= 0 && x <= 4) {
      RC_ASSERT(now);
    } else if (x < -0.201 || x > 4.201) {
      RC_ASSERT(!now);
    } else if (x > -0.199 && x < 4.199) {
      RC_ASSERT(now == inside);
    }
    inside = now;
  }
}

// Every atom of a group is true, false or in doubt, and of an exclusive group at most one is true.
RC_GTEST_PROP(Observer, HasOneRegionForEachThingThatItSees, ()) {
  Observer observer(rules(R"(
rules:
  - {fact: '(at ?who ?room)', when: '?who in ?room', for: {who: [robot, cup, ann], room: [hall, kitchen]}, exactly_one: room}
)"));
  for (int step = 0; step < 5; ++step) {
    std::vector<Sighting> sightings;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool visible = *rc::gen::arbitrary<bool>();
      seen += visible ? 1 : 0;
      sightings.push_back(visible ? at(*rc::gen::inRange(0, 80) / 10.0) : missing("gone"));
    }
    const Observation now = observer.observe(sightings);
    RC_ASSERT(now.holds.size() == seen);
    RC_ASSERT(now.doubts.size() == 3 - seen);
    std::set<std::string> things;
    for (const GroundName& atom : now.holds)
      things.insert(atom.arguments[0]);
    RC_ASSERT(things.size() == seen);
  }
}

}  // namespace
}  // namespace goal_alignment::spatial_facts
