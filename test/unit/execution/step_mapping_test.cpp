// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/execution/step_mapping.h"

#include <gtest/gtest.h>

#include "goal_alignment/pddl/model.h"
#include "goal_alignment/pddl/source_position.h"
#include "goal_alignment/ros_common/package_files.h"
#include "samples.h"

namespace goal_alignment::execution::test {
namespace {

class Mapping : public testing::Test {
 protected:
  StepMapping read(const std::string& yaml, std::optional<StepKind> kind = std::nullopt) {
    return StepMapping::fromYaml(yaml, "m.yaml", types_, kind);
  }
  std::string fault(const std::string& yaml) {
    return faultOfCall([&] { read(yaml); });
  }

  any_message::MessageTypes types_ =
      typesOf({{"robot/action/Go", "string to\n---\nbool done\nint32 code\n---\n"},
               {"robot/srv/Open", "string door\n---\nbool success\n"}});
};

TEST_F(Mapping, thatIsEmptyLeavesEverythingToTheNode) {
  EXPECT_EQ(read("").find("go"), nullptr);
  EXPECT_EQ(read("", StepKind::Simulated).find("go")->kind, StepKind::Simulated);
}

TEST_F(Mapping, readsEveryKind) {
  const StepMapping mapping = read(R"yaml(
tables: {pose: {Hall: [0, 0, 0]}}
default: {kind: dispatch, timeout: 7, retries: 2}
actions:
  Go: {kind: action, name: move, type: robot/Go, goal: {to: "{to}"}, success_field: {code: 3}, retries: 0}
  open: {kind: service, name: /open, type: robot/Open, success_field: success, on_failure: stop}
  look: {kind: simulated, duration: 2, failure_probability: 0.5, moves: [{frame: head, to: [0, 0, 1]}],
         failure_facts: ["(not (seen {0}))"]}
frames: {head: {parent: base, pose: [1, 2, 3, 0]}}
failures: {(look a): always, look b: 2}
)yaml");
  EXPECT_EQ(mapping.find("wash")->kind, StepKind::Dispatch);
  EXPECT_EQ(mapping.find("wash")->timeout, 7);
  const StepRule& go = *mapping.find("GO");
  EXPECT_EQ(go.kind, StepKind::Action);
  EXPECT_EQ(go.timeout, 7) << "of the default";
  EXPECT_EQ(go.retries, 0);
  EXPECT_EQ(go.success.at(0).first, "code");
  EXPECT_TRUE(mapping.find("open")->stop_on_failure);
  EXPECT_EQ(mapping.find("open")->success.at(0).second.Scalar(), "true");
  EXPECT_EQ(mapping.find("look")->moves.size(), 1U);
  EXPECT_EQ(mapping.find("look")->failure_facts.size(), 1U);
  EXPECT_EQ(mapping.failures.at(GroundName::parse("look a")), StepRule::kAlways);
  EXPECT_EQ(mapping.failures.at(GroundName::parse("look b")), 2);
  EXPECT_EQ(mapping.frames.at(0).parent, "base");
}

TEST_F(Mapping, takesFromTheDefaultWhatAnActionDoesNotSayAndKeepsItApart) {
  const StepMapping mapping = read(R"yaml(
default: {kind: service, name: /any, type: robot/Open, request: {door: "{0}"}}
actions: {a: {name: /a}, b: {request: {door: front}}, c: {}}
)yaml");
  EXPECT_EQ(mapping.find("a")->name.Scalar(), "/a");
  EXPECT_EQ(mapping.find("b")->name.Scalar(), "/any");
  EXPECT_EQ(mapping.find("c")->name.Scalar(), "/any");
  EXPECT_EQ(mapping.find("else")->name.Scalar(), "/any");
  EXPECT_EQ(mapping.find("b")->fields["door"].Scalar(), "front");
  EXPECT_EQ(mapping.find("c")->fields["door"].Scalar(), "{0}");
}

TEST_F(Mapping, takesTheFormerNameOfServerTimeoutAndWarns) {
  const StepMapping mapping = read("actions:\n  go: {kind: dispatch, server_patience: 7}\n");
  EXPECT_EQ(mapping.find("go")->server_timeout, 7);
  EXPECT_EQ(mapping.warnings, std::vector<std::string>{
                                  "m.yaml:2:41: server_patience is now called server_timeout; the "
                                  "name server_patience will be removed in the next release"});
  EXPECT_EQ(fault("actions: {go: {kind: simulated, server_patience: 7}}").substr(0, 33),
            "m.yaml:1:33: unknown key 'server_");
}

TEST_F(Mapping, saysWhereItsFaultIs) {
  EXPECT_EQ(fault("actions:\n  go: {kind: fly}"),
            "m.yaml:2:14: expected one of action, service, dispatch, simulated, found 'fly'");
  EXPECT_EQ(fault("actions: {go: {}}"), "m.yaml:1:15: no `kind`, and none in `default`");
  EXPECT_EQ(fault("actons: {}").substr(0, 44), "m.yaml:1:1: unknown key 'actons': expected o");
  EXPECT_EQ(fault("actions: {go: {kind: dispatch, goal: {}}}").substr(0, 30),
            "m.yaml:1:32: unknown key 'goal");
  EXPECT_EQ(fault("actions: {go: {kind: dispatch}, GO: {kind: dispatch}}"),
            "m.yaml:1:33: 'GO' stands twice");
  EXPECT_EQ(fault("default: {kind: dispatch, timeout: -1}"),
            "m.yaml:1:36: expected a number, 0 to 86400, found '-1'");
  EXPECT_EQ(fault("default: {kind: dispatch, retries: few}"),
            "m.yaml:1:36: expected a whole number from 0 to 1000, found 'few'");
  EXPECT_EQ(fault("actions: {go: {kind: action, name: x}}"),
            "m.yaml:1:15: no `type` of the server: package/Name");
  EXPECT_EQ(fault("actions: {go: {kind: action, type: robot/Go}}"),
            "m.yaml:1:15: no `name` of a server");
  EXPECT_EQ(fault("actions: {go: {kind: action, name: x, type: robot/Fly}}"),
            "m.yaml:1:45: the type robot/FlyGoal is not known: no msg/FlyGoal.msg of package robot "
            "is installed");
  EXPECT_EQ(fault("actions: {go: {kind: action, name: x, type: robot/Go, goal: {from: a}}}"),
            "m.yaml:1:62: robot/GoGoal has no field 'from', but to");
  EXPECT_EQ(fault("actions: {go: {kind: action, name: x, type: robot/Go, success_field: ok}}"),
            "m.yaml:1:70: robot/GoResult has no field 'ok', but done, code");
  EXPECT_EQ(fault("frames: {a: {parent: b}, b: {parent: a}}"),
            "m.yaml:1:10: the frame 'a' hangs from itself");
  EXPECT_EQ(fault("frames: {a: {parent: b, pose: [1]}}"),
            "m.yaml:1:31: expected a pose: [x, y, yaw], [x, y, z, yaw] or a map of position and "
            "orientation, found a list");
  EXPECT_EQ(fault("actions: {go: {kind: simulated, moves: [{frame: a}]}}"),
            "m.yaml:1:41: neither `to` nor `parent`");
  EXPECT_EQ(fault("failures: {\"(\": 1}").substr(0, 13), "m.yaml:1:12: ");
  EXPECT_NE(fault("actions: [").find("m.yaml:"), std::string::npos);
  EXPECT_EQ(fault("- a").substr(0, 12), "m.yaml:1:1: ");
}

TEST(ExampleMapping, isReadWithTheTypesThatItNames) {
  any_message::MessageTypes types(any_message::installedDefinition);
  const pddl::Source file = pddl::readFile(ros_common::resolveFile("config/execution.yaml"));
  const StepMapping mapping = StepMapping::fromYaml(file.text, file.name, types, std::nullopt);
  ASSERT_NE(mapping.find("go"), nullptr);
  EXPECT_EQ(mapping.find("go")->kind, StepKind::Action);
}

TEST(ExampleMapping, ofTheTutorialSaysHowEachActionIsCarriedOut) {
  any_message::MessageTypes types(any_message::installedDefinition);
  const std::string ward = "config/domains/ward/";
  const pddl::Model robot =
      pddl::readModel(pddl::readFile(ros_common::resolveFile(ward + "robot_domain.pddl")),
                      pddl::readFile(ros_common::resolveFile(ward + "robot_problem.pddl")));
  const pddl::Source file = pddl::readFile(ros_common::resolveFile(ward + "robot_execution.yaml"));
  const StepMapping mapping = StepMapping::fromYaml(file.text, file.name, types, std::nullopt);
  for (const pddl::Schema& schema : robot.schemas)
    EXPECT_NE(mapping.find(schema.name.name), nullptr) << schema.name.name;
}

}  // namespace
}  // namespace goal_alignment::execution::test
