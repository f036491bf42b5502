// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/mapping_check.h"

#include <gtest/gtest.h>

#include "samples.h"

namespace goal_alignment::execution::test {
namespace {

constexpr const char* kDomain = R"((define (domain d) (:requirements :adl)
  (:types room thing) (:predicates (at ?r - room) (shut ?a ?b - room) (has ?t - thing))
  (:action walk :parameters (?from ?to - room) :precondition (at ?from) :effect (at ?to))
  (:action grasp :parameters (?t - thing ?r - room) :precondition (at ?r) :effect (has ?t))))";
constexpr const char* kProblem =
    "(define (problem p) (:domain d) (:objects hall kitchen - room cup - thing) (:init)"
    " (:goal (has cup)))";

class Misfits : public testing::Test {
 protected:
  std::vector<std::string> of(const std::string& yaml,
                              std::optional<StepKind> kind = std::nullopt) {
    return misfits(StepMapping::fromYaml(yaml, "m.yaml", types_, kind), robot_);
  }

  any_message::MessageTypes types_ = typesOf({{"robot/action/Go", "string to\n---\n---\n"}});
  pddl::Model robot_ = pddl::readModel({"d", kDomain}, {"p", kProblem});
};

using Texts = std::vector<std::string>;

TEST_F(Misfits, areNoneWhereAllFits) {
  EXPECT_EQ(of(R"yaml(
tables: {pose: {Hall: a, KITCHEN: b, garden: c}}
actions:
  Walk: {kind: action, name: "{action}", type: robot/Go, goal: {to: "{pose:to} {{x}} {0}"},
         failure_facts: ["(shut {from} {To})"]}
  grasp: {kind: simulated, moves: [{frame: "{t}", parent: hand}]}
failures: {(walk hall kitchen): 1}
)yaml"),
            Texts{});
}

TEST_F(Misfits, areActionsThatOneOfBothLacks) {
  EXPECT_EQ(of("actions:\n  walk: {kind: dispatch}\n  garsp: {kind: dispatch}"),
            (Texts{"m.yaml:3:3: the robot's domain has no action 'garsp'; did you mean 'grasp'?",
                   "m.yaml: nothing says how to carry out the robot's action 'grasp'; did you mean "
                   "'garsp'?"}));
  EXPECT_EQ(of("default: {kind: dispatch}\nfailures: {(wlk hall): 1}"),
            Texts{"m.yaml: in failures: the robot's domain has no action 'wlk'; did you mean "
                  "'walk'?"});
  EXPECT_EQ(of("", StepKind::Simulated), Texts{});
}

TEST_F(Misfits, areParametersThatTheActionDoesNotHave) {
  EXPECT_EQ(
      of(R"yaml(
default: {kind: dispatch}
actions:
  walk: {kind: action, name: "/{form}", type: robot/Go, goal: {to: "{2}"}}
)yaml"),
      (Texts{"m.yaml:4:30: the action walk has no parameter 'form', but from, to; did you mean "
             "'from'?",
             "m.yaml:4:68: the action walk has no parameter '2', but from, to"}));
}

TEST_F(Misfits, areTablesWithoutWhatIsAskedOfThem) {
  EXPECT_EQ(
      of(R"yaml(
tables:
  pose: {hall: a, kichen: b}
default: {kind: dispatch}
actions:
  walk: {kind: action, name: go, type: robot/Go, goal: {to: "{pose:to} {pos:from}"}}
)yaml"),
      (Texts{"m.yaml:6:61: table 'pose' has no entry for kitchen, which ?to of walk may be; did "
             "you mean 'kichen'?",
             "m.yaml:3:19: no object is called 'kichen'; did you mean 'kitchen'?",
             "m.yaml:6:61: there is no table 'pos'; did you mean 'pose'?"}));
}

TEST_F(Misfits, areFailureFactsThatCanNotBe) {
  EXPECT_EQ(of(R"yaml(
default: {kind: dispatch}
actions:
  walk: {failure_facts: ["(shutt {from} {to})", "(shut {to})", "(not (at attic))"]}
)yaml"),
            (Texts{"m.yaml:4:26: the robot's domain has no predicate 'shutt'; did you mean 'shut'?",
                   "m.yaml:4:49: 'shut' takes 2 arguments, found 1",
                   "m.yaml:4:64: the robot's problem has no object 'attic'"}));
}

}  // namespace
}  // namespace goal_alignment::execution::test
