// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/common/exceptions.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/pddl/model.h"
#include "goal_alignment/spatial_facts/geometry.h"

/// Facts from where things are. Rules say which atoms follow from the places of tf frames; where
/// the frames are somebody else tells (Sighting), so that nothing here knows of ROS. The file, with
/// all that may stand in it, is explained in config/tf_facts.yaml:
///
///     frames: {robot: base_link}
///     regions:
///       kitchen: {box: {xyz: [2, 1, 0], size: [4, 3]}}
///       hall: {cylinder: {xyz: [6, 1, 0], radius: 1.5}}
///     rules:
///       - fact: (at ?who ?room)
///         when: ?who in ?room
///         for: {who: robot, room: [kitchen, hall]}
///         exactly_one: room
///
/// A rule owns every ground atom of its pattern: those geometry does not make true are false,
/// whatever the problem file or anybody else says.
namespace goal_alignment::spatial_facts {

/// What becomes of an atom that nobody can tell, since its frames are missing or old.
enum class Unknown : std::uint8_t {
  Fail,      ///< the robot's state is unknown
  TrustFile  ///< as the problem file and ~set_facts say
};

/// One place that has to be known: where the frame `of` is, in the frame `in`.
struct FramePair {
  std::string in;
  std::string of;
};

/// A question that the places of one or two frames answer.
struct Probe {
  std::size_t subject = 0;            ///< index of a FramePair
  std::optional<std::size_t> other;   ///< distances within the horizontal plane: the other's place
  std::optional<std::size_t> region;  ///< index of a Region; else it is a distance to the frame
  double reach = 0;                   ///< of a distance, metres
  bool negated = false;               ///< `outside` and `beyond`
};

/// A thing that a rule decides by itself.
struct Group {
  /// An atom that is true where one of the probes is. Without exactly_one the only one.
  struct Option {
    GroundName atom;
    std::vector<Probe> probes;
    std::string place;  ///< with exactly_one: the region's name
  };
  std::vector<Option> options;
  std::string subject;  ///< with exactly_one: what is somewhere, and its frame, for messages
};

/// With exactly_one: what holds where the thing is in none of the regions.
enum class Otherwise : std::uint8_t { Unknown, Nothing, Nearest, Object };

struct Rule {
  std::string place;     ///< `file:line:column`, for messages
  GroundName pattern;    ///< variables as `?name`
  std::size_t slot = 0;  ///< with exactly_one: which argument it is that has one value
  bool exactly_one = false;
  Otherwise otherwise = Otherwise::Unknown;
  std::string otherwise_object;
  double max_age = 0;  ///< seconds
  double margin = 0;   ///< metres
  Unknown unknown = Unknown::Fail;
  std::vector<Group> groups;
  /// By argument: the objects it owns atoms of; empty: all.
  std::vector<std::vector<std::string>> owned;

  bool owns(const GroundName& atom) const;
  /// With exactly_one, the same for all atoms of a group: `(at robot ?)`. Else the atom.
  GroundName key(GroundName atom) const;
};

/// A file of rules. Immutable once read.
class Rules {
 public:
  /// Throws YamlError. `source_name` is what errors call the text.
  static std::shared_ptr<const Rules> fromYaml(const std::string& text,
                                               const std::string& source_name);

  /// Throws RulesError at the first rule whose atoms the robot's model can't have.
  void check(const pddl::Model& model) const;

  /// The rule that owns the atom, or null. O(rules).
  const Rule* ownerOf(const GroundName& atom) const;

  const std::string& text() const { return text_; }
  const std::vector<FramePair>& pairs() const { return pairs_; }
  const std::vector<Region>& regions() const { return regions_; }
  const std::vector<Rule>& rules() const { return rules_; }

 private:
  friend class RulesReader;

  std::string text_;
  std::vector<FramePair> pairs_;
  std::vector<Region> regions_;
  std::vector<Rule> rules_;
};

/// Rules that don't fit the robot's model; what() names file, line and atom.
class RulesError : public Exception {
 public:
  using Exception::Exception;
};

}  // namespace goal_alignment::spatial_facts
