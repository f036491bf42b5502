// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/spatial_facts/rules.h"

#include <gtest/gtest.h>

#include "goal_alignment/common/yaml_reader.h"
#include "samples.h"
#include "unit/source_root.h"

namespace goal_alignment::spatial_facts {
namespace {

using samples::location;
using samples::rules;

std::string faultOf(const std::string& text) {
  try {
    Rules::fromYaml(text, "x.yaml");
  } catch (const YamlError& error) {
    return error.what();
  }
  return "none";
}

// With the rooms and frames of samples.h; lines count from the rules on.
std::string ruleFault(const std::string& rule) {
  return faultOf(std::string(samples::kRooms) + "rules:\n  - " + rule + "\n");
}

void expectFault(const std::string& fault, const std::string& place, const std::string& part) {
  EXPECT_EQ(fault.rfind("x.yaml:" + place + ": ", 0), 0U) << fault;
  EXPECT_NE(fault.find(part), std::string::npos) << fault;
}

TEST(Rules, ReadEverythingThatMayStandInThem) {
  const auto read = Rules::fromYaml(R"(
defaults: {frame: odom, max_age: .inf, margin: 0, unknown: trust_file}
frames: {Robot: base_link}
regions:
  Kitchen:
    - {box: {xyz: [1, 2, 3], rpy: [0, 0, 1.57], size: [1, 2, 3]}, frame: kitchen_origin}
    - cylinder: {radius: 1, length: 2}
  spot: {sphere: {xyz: [0, 0, 0], radius: 0.5}}
rules:
  - fact: (AT ?Who ?room)
    when: ?who in ?ROOM
    for:
      ?who: [ROBOT]
      room: [kitchen, spot]
    exactly_one: ?room
    otherwise: Garden
    max_age: 3
    margin: 0.5
    unknown: fail
  - fact: (parked)
    when: robot in spot
)",
                                    "x.yaml");
  ASSERT_EQ(read->regions().size(), 2U);
  EXPECT_EQ(read->regions()[0].frame, "kitchen_origin");
  EXPECT_EQ(read->regions()[0].shapes.size(), 2U);
  EXPECT_EQ(read->regions()[1].frame, "odom");
  ASSERT_EQ(read->pairs().size(), 2U);
  ASSERT_EQ(read->rules().size(), 2U);
  const Rule& location = read->rules()[0];
  EXPECT_EQ(location.place, "x.yaml:10:11");
  EXPECT_EQ(location.groups.size(), 1U);
  EXPECT_EQ(location.groups[0].options.size(), 2U);
  EXPECT_EQ(location.groups[0].options[1].atom.text(), "(at robot spot)");
  EXPECT_EQ(location.otherwise, Otherwise::Object);
  EXPECT_EQ(location.otherwise_object, "garden");
  EXPECT_EQ(location.max_age, 3);
  EXPECT_EQ(location.margin, 0.5);
  EXPECT_EQ(location.unknown, Unknown::Fail);
  EXPECT_EQ(read->rules()[1].unknown, Unknown::TrustFile);
  EXPECT_GT(read->rules()[1].max_age, 1e12);
}

TEST(Rules, OwnTheAtomsOfTheirPatternInEveryRegion) {
  const auto one = location();
  const auto owned = [&](const std::string& atom) {
    return one->ownerOf(GroundName::parse(atom)) != nullptr;
  };
  EXPECT_TRUE(owned("(at robot kitchen)"));
  EXPECT_TRUE(owned("(at robot cellar)")) << "a region without a shape";
  EXPECT_FALSE(owned("(at cup kitchen)"));
  EXPECT_FALSE(owned("(at robot)"));
  EXPECT_FALSE(owned("(in robot kitchen)"));
  const auto near = rules(
      "rules: [{fact: '(near ?a robot)', when: '?a within 1 of robot', for: {a: "
      "[cup, ann]}}]\n");
  EXPECT_NE(near->ownerOf(GroundName::parse("(near cup robot)")), nullptr);
  EXPECT_EQ(near->ownerOf(GroundName::parse("(near table robot)")), nullptr)
      << "it has no frame, so the file says";
}

TEST(Rules, AnEmptyFileHasNone) {
  EXPECT_TRUE(Rules::fromYaml("", "x.yaml")->rules().empty());
  EXPECT_TRUE(Rules::fromYaml("rules:\nframes:\n", "x.yaml")->rules().empty());
}

TEST(Rules, FaultsOfTheFileNamePlaceAndWhatWasExpected) {
  expectFault(faultOf("[1]"), "1:1", "a map with defaults, frames, regions, rules");
  expectFault(faultOf("rules: {}\nrulez: []"), "2:1", "found 'rulez'");
  expectFault(faultOf("rules: []\nrules: []"), "2:1", "each name once");
  expectFault(faultOf("rules: {a: 1}"), "1:8", "a list of rules, found a map");
  expectFault(faultOf("rules: [}"), "1:9", "YAML");
  expectFault(faultOf("rules: [{fact: (at ?x)}]"), "1:20", "quotes around a text with '?'");
  expectFault(faultOf("---\n---\n"), "2:1", "one document");
  expectFault(faultOf("defaults: {max_age: -1}"), "1:21", "max_age: seconds, 0.01 to inf");
  expectFault(faultOf("defaults: {max_age: .nan}"), "1:21", "found '.nan'");
  expectFault(faultOf("defaults: {margin: wide}"), "1:20", "margin: metres");
  expectFault(faultOf("defaults: {unknown: guess}"), "1:21", "fail or trust_file");
  expectFault(faultOf("defaults: {frame: /map}"), "1:19", "no slash");
  expectFault(faultOf("frames: {robot: }"), "1:17", "a tf frame");
  expectFault(faultOf("frames: {robot: a, ROBOT: b}"), "1:20", "each object once");
  expectFault(faultOf("frames: {a robot: a}"), "1:10", "an object's name");
}

TEST(Rules, FaultsOfRegions) {
  const auto region = [](const std::string& text) { return faultOf("regions:\n  a: " + text); };
  expectFault(region("1"), "2:6", "a box, a cylinder or a sphere, found '1'");
  expectFault(region("{}"), "2:6", "found none");
  expectFault(region("[]"), "2:6", "1 to 1000 shapes");
  expectFault(region("{ball: {}}"), "2:7", "found 'ball'");
  expectFault(region("{box: {size: [1, 1]}, sphere: {radius: 1}}"), "2:6", "write a list");
  expectFault(region("{box: {xyz: [0, 0, 0]}}"), "2:12", "'size'");
  expectFault(region("{box: {size: [1]}}"), "2:19", "two or three numbers");
  expectFault(region("{box: {size: [1, 0]}}"), "2:23", "found '0'");
  expectFault(region("{box: {size: [1, 1], xyz: [1, 2]}}"), "2:32", "three numbers");
  expectFault(region("{box: {size: [1, 1], rpy: [0, 0, 90]}}"), "2:39", "-7 to 7");
  expectFault(region("{box: {size: [1, 1], yaw: 1}}"), "2:27", "found 'yaw'");
  expectFault(region("{cylinder: {length: 1}}"), "2:17", "'radius'");
  expectFault(region("{cylinder: {radius: -1}}"), "2:26", "radius: metres");
  expectFault(region("[{sphere: {radius: 1}, frame: a}, {sphere: {radius: 1}, frame: b}]"), "2:69",
              "in one frame, 'a'");
  expectFault(faultOf("regions: {a: {sphere: {radius: 1}}, A: {sphere: {radius: 1}}}"), "1:37",
              "each region once");
}

TEST(Rules, FaultsOfARule) {
  expectFault(ruleFault("{when: robot in hall}"), "8:5", "'fact'");
  expectFault(ruleFault("{fact: (at)}"), "8:5", "'when'");
  expectFault(ruleFault("{fact: ((at), when: robot in hall}"), "8:12", "an atom such as");
  expectFault(ruleFault("{fact: '(at ?x)', when: robot in hall}"), "8:12", "found '?x'");
  expectFault(ruleFault("{fact: (at), when: robot near hall}"), "8:24", "A in REGION");
  expectFault(ruleFault("{fact: (at), when: robot within two of cup}"), "8:24", "metres");
  expectFault(ruleFault("{fact: (at), when: robot within -2 of cup}"), "8:24", "metres");
  expectFault(ruleFault("{fact: (at), when: robot within nan of cup}"), "8:24", "metres");
  expectFault(ruleFault("{fact: (at), when: table in hall}"), "8:24", "stands in 'frames'");
  expectFault(ruleFault("{fact: (at), when: robot in cellar}"), "8:24", "stands in 'regions'");
  expectFault(ruleFault("{fact: (at), when: robot in hall, for: {a: []}}"), "8:48", "an object");
  expectFault(ruleFault("{fact: (at), when: robot in hall, for: {a: b}}"), "8:12", "'?a'");
  expectFault(ruleFault("{fact: '(at ?a ?a)', when: '?a in hall', for: {a: robot}}"), "8:12",
              "each variable once");
  expectFault(ruleFault("{fact: (at), when: robot in hall, exactly_one: room}"), "8:52",
              "behind 'in'");
  expectFault(
      ruleFault("{fact: '(at ?r)', when: 'robot outside ?r', for: {r: hall}, exactly_one: r}"),
      "8:78", "behind 'in'");
  expectFault(
      ruleFault("{fact: '(at ?r)', when: '?a in ?r', for: {a: robot, r: hall}, exactly_one: r}"),
      "8:12", "'?a' in the fact");
  expectFault(ruleFault("{fact: (at), when: '?r in ?r', for: {r: hall}, exactly_one: r}"), "8:65",
              "no region");
  expectFault(ruleFault("{fact: (at), when: robot in hall, otherwise: nothing}"), "8:50",
              "only with exactly_one");
  expectFault(ruleFault("{fact: (at), when: robot in hall, horizontal: true}"), "8:51", "'within'");
  expectFault(ruleFault("{fact: (at), when: robot within 1 of cup, horizontal: 7}"), "8:59",
              "true or false");
  expectFault(ruleFault("{fact: (at), when: robot in hall, maxage: 1}"), "8:39", "'maxage'");
  expectFault(ruleFault("{fact: (at robot hall), when: robot in hall}\n"
                        "  - {fact: '(at ?a hall)', when: '?a in hall', for: {a: [robot, cup]}}"),
              "9:12", "(x.yaml:8:12) own the same atoms");
}

TEST(Rules, OfTheExampleCanBeRead) {
  const std::string name = (sourceRoot() / "config/tf_facts.yaml").string();
  const pddl::Source example = pddl::readFile(name);
  const auto read = Rules::fromYaml(example.text, example.name);
  EXPECT_EQ(read->rules().size(), 4U);
  EXPECT_EQ(read->regions().size(), 4U);
  EXPECT_EQ(read->regions()[3].frame, "tray_link");
}

TEST(Rules, OfTheTutorialCanBeRead) {
  const auto path = sourceRoot() / "config/domains/ward/tf_facts.yaml";
  const std::string name = path.string();
  const auto read = Rules::fromYaml(pddl::readFile(name).text, name);
  EXPECT_EQ(read->rules().size(), 1U);
  EXPECT_EQ(read->regions().size(), 4U);
}

TEST(Rules, AFewBytesCannotBecomeTooMuchWork) {
  std::string text = "frames: {o0: f";
  std::string list = "[o0";
  for (int i = 1; i < 400; ++i) {
    text += ", o" + std::to_string(i) + ": f" + std::to_string(i);
    list += ", o" + std::to_string(i);
  }
  text += "}\nrules:\n  - {fact: '(p ?a ?b)', when: '?a within 1 of ?b', for: {a: &all " + list +
          "], b: *all}}\n";
  expectFault(faultOf(text), "3:12", "at most 100000 atoms");
}

TEST(Rules, AreCheckedAgainstTheRobotsModel) {
  const pddl::Model model = pddl::readModel(
      {"domain",
       "(define (domain d) (:requirements :typing) (:types thing room) "
       "(:predicates (at ?t - thing ?r - room) (parked)))"},
      {"problem",
       "(define (problem q) (:domain d) (:objects robot cup - thing kitchen hall - room) (:init) "
       "(:goal (parked)))"});
  location()->check(model);
  const auto fault = [&](const std::shared_ptr<const Rules>& read) -> std::string {
    try {
      read->check(model);
    } catch (const RulesError& error) {
      return error.what();
    }
    return "none";
  };
  const auto rule = [](const std::string& text) { return rules("rules:\n  - " + text + "\n"); };
  expectFault(fault(rule("{fact: (parkd), when: robot in hall}")), "8:12", "parkd");
  expectFault(fault(rule("{fact: (parked robot), when: robot in hall}")), "8:12",
              "can't have (parked robot)");
  expectFault(fault(rule("{fact: '(at ?w hall)', when: '?w in hall', for: {w: [robot, ann]}}")),
              "8:12", "ann");
  expectFault(fault(rule("{fact: (at hall robot), when: robot in hall}")), "8:12",
              "can't have (at hall robot)");
  expectFault(fault(location("garden")), "9:11", "garden");
}

}  // namespace
}  // namespace goal_alignment::spatial_facts
