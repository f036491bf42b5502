// SPDX-License-Identifier: BSD-3-Clause
#include "fact_services.h"

#include <fmt/format.h>

#include <string>

#include "goal_alignment/ros_common/names.h"

namespace goal_alignment::aligner {

FactServices::FactServices(const ros::NodeHandle& private_node, const Dependencies& parts)
    : parts_(parts), services_(private_node), slow_services_(private_node, 1) {
  using std_srvs::Trigger;
  services_.add<SetFacts>(ros_common::kSetFactsService,
                          [this](const SetFacts::Request& request, SetFacts::Response& response) {
                            setFacts(request, response);
                          });
  slow_services_.add<SetFacts>(
      ros_common::kSetHumanFactsService,
      [this](const SetFacts::Request& request, SetFacts::Response& response) {
        setHumanFacts(request, response);
      });
  slow_services_.add<Trigger>(
      ros_common::kForgetFactsService,
      [this](const Trigger::Request&, Trigger::Response& response) { forgetFacts(response); });
  slow_services_.add<GetFacts>(
      ros_common::kGetFactsService,
      [this](const GetFacts::Request&, GetFacts::Response& response) { getFacts(response); });
}

void FactServices::setFacts(const SetFacts::Request& request, SetFacts::Response& response) {
  const session::SubmitResult receipt = parts_.facts.set(request.facts, parts_.tf.rules().get());
  response.accepted = receipt.accepted;
  response.message = receipt.message;
  if (receipt.accepted) parts_.bridge.wakeUp();
}

// If the person's model can't be read, the next task leaves out the facts that it can't have.
void FactServices::setHumanFacts(const SetFacts::Request& request, SetFacts::Response& response) {
  std::string why_not;
  const ParameterModels::Model human = parts_.models.human(why_not);
  const session::SubmitResult receipt = parts_.facts.setHuman(request.facts, human.get());
  response.accepted = receipt.accepted;
  response.message = receipt.message;
  if (receipt.accepted && !human)
    response.message = "taken; the person's model can't be read: " + why_not;
}

void FactServices::forgetFacts(std_srvs::Trigger::Response& response) {
  response.success = 1;
  response.message =
      fmt::format("all facts that were set are forgotten ({}): the problem files apply again",
                  parts_.facts.forget());
  parts_.bridge.wakeUp();
}

void FactServices::getFacts(GetFacts::Response& response) {
  const spatial_facts::Observation seen = parts_.tf.look();
  response = parts_.facts.tell(seen);
  if (!response.session_id.empty()) return;
  std::string why_not;
  const ParameterModels::Model next = parts_.models.robot(why_not);
  response = parts_.facts.tellBefore(next, why_not, seen);
}

}  // namespace goal_alignment::aligner
