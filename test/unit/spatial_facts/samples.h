// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/spatial_facts/observer.h"
#include "goal_alignment/spatial_facts/rules.h"

namespace goal_alignment::spatial_facts::samples {

/// Two rooms side by side along x: the kitchen from 0 to 4, the hall from 4 to 8.
constexpr const char* kRooms = R"(
defaults: {max_age: 2, margin: 0.2}
frames: {robot: base_link, cup: cup_link, ann: ann_head}
regions:
  kitchen: {box: {xyz: [2, 0, 0], size: [4, 4]}}
  hall: {box: {xyz: [6, 0, 0], size: [4, 4]}}
)";

inline std::shared_ptr<const Rules> rules(const std::string& text,
                                          const std::string& before = kRooms) {
  return Rules::fromYaml(before + text, "x.yaml");
}

inline std::shared_ptr<const Rules> location(const std::string& otherwise = "unknown",
                                             const std::string& more = "") {
  return rules(R"(
rules:
  - fact: (at ?who ?room)
    when: ?who in ?room
    for: {who: robot, room: [kitchen, hall]}
    exactly_one: room
    otherwise: )" +
               otherwise + "\n" + more);
}

inline Sighting at(double x, double y = 0, double z = 0) {
  Sighting sighting;
  sighting.known = true;
  sighting.position = {x, y, z};
  return sighting;
}

inline Sighting aged(Sighting sighting, double age) {
  sighting.age = age;
  return sighting;
}

inline Sighting missing(const std::string& why) {
  Sighting sighting;
  sighting.why = why;
  return sighting;
}

inline std::set<std::string> texts(const std::set<GroundName>& atoms) {
  std::set<std::string> result;
  for (const GroundName& atom : atoms)
    result.insert(atom.text());
  return result;
}

}  // namespace goal_alignment::spatial_facts::samples
