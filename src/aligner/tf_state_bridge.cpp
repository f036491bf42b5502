// SPDX-License-Identifier: BSD-3-Clause
#include "tf_state_bridge.h"

#include <ros/time.h>
#include <tf2/exceptions.h>

#include <string>
#include <utility>
#include <vector>

#include "goal_alignment/common/ground_name.h"

namespace goal_alignment::aligner {
namespace {

using spatial_facts::FramePair;
using spatial_facts::Sighting;

// The newest transform. Its stamp is that of the oldest link of the chain; zero where none moves.
Sighting sight(const tf2_ros::Buffer& buffer, const FramePair& frames, const ros::Time& now) {
  Sighting sighting;
  try {
    const auto transform = buffer.lookupTransform(frames.in, frames.of, ros::Time(0));
    const auto& place = transform.transform.translation;
    sighting.known = true;
    sighting.position = {place.x, place.y, place.z};
    const ros::Time& stamp = transform.header.stamp;
    if (!stamp.isZero())
      sighting.age = now.toSec() - stamp.toSec();  // garbage is too much for a Duration
  } catch (const tf2::TransformException& error) {
    sighting.why = std::string(trimmed(error.what()));
  }
  return sighting;
}

}  // namespace

TfStateBridge::TfStateBridge(const tf2_ros::Buffer& frames) : frames_(frames) {}

void TfStateBridge::follow(std::shared_ptr<const spatial_facts::Rules> rules) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!rules) {
    observer_.reset();
    return;
  }
  if (observer_ && observer_->rules()->text() == rules->text()) return;
  observer_.emplace(std::move(rules));
}

std::shared_ptr<const spatial_facts::Rules> TfStateBridge::rules() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return observer_ ? observer_->rules() : nullptr;
}

spatial_facts::Observation TfStateBridge::look() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!observer_) return {};
  const ros::Time now = ros::Time::now();
  std::vector<Sighting> sightings;
  for (const FramePair& frames : observer_->rules()->pairs())
    sightings.push_back(sight(frames_, frames, now));
  return observer_->observe(sightings);
}

}  // namespace goal_alignment::aligner
