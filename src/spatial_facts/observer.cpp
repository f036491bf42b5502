// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/spatial_facts/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "goal_alignment/common/listed.h"

namespace goal_alignment::spatial_facts {

namespace {

constexpr std::size_t kMaxDoubts = 3;  // that a message names
constexpr std::size_t kMaxAtoms = 2;   // of each

/// What one rule makes of the sightings.
class Look {
 public:
  Look(const Rules& rules, const Rule& rule, const std::vector<Sighting>& sightings)
      : rules_(rules), rule_(rule), sightings_(sightings) {}

  /// Why the probe can't be told; empty: it can.
  std::string trouble(const Probe& probe) const {
    const std::string first = trouble(probe.subject);
    return first.empty() && probe.other ? trouble(*probe.other) : first;
  }

  /// How far what is asked is from being so, regardless of `negated`; not positive: it is so.
  double distance(const Probe& probe) const {
    const Vector& position = sightings_[probe.subject].position;
    if (probe.region) return distanceTo(rules_.regions()[*probe.region], position);
    if (!probe.other) return length(position) - probe.reach;
    const Vector apart = position - sightings_[*probe.other].position;
    return std::hypot(apart.x, apart.y) - probe.reach;
  }

 private:
  std::string trouble(std::size_t pair) const {
    const FramePair& frames = rules_.pairs()[pair];
    const Sighting& sighting = sightings_[pair];
    if (!sighting.known) {
      return fmt::format("where frame {} is in {} is not known: {}", frames.of, frames.in,
                         sighting.why);
    }
    if (!std::isfinite(length(sighting.position))) {
      return fmt::format("where frame {} is in {} is no number", frames.of, frames.in);
    }
    if (!sighting.age || std::abs(*sighting.age) <= rule_.max_age) return {};
    if (*sighting.age < 0) {
      return fmt::format("where frame {} is in {} is dated {:.1f} s in the future, more than {} s",
                         frames.of, frames.in, -*sighting.age, rule_.max_age);
    }
    return fmt::format("where frame {} is in {} was last known {:.1f} s ago, more than {} s",
                       frames.of, frames.in, *sighting.age, rule_.max_age);
  }

  const Rules& rules_;
  const Rule& rule_;
  const std::vector<Sighting>& sightings_;
};

std::string listOf(const std::vector<GroundName>& atoms) {
  std::string text;
  for (std::size_t i = 0; i < std::min(atoms.size(), kMaxAtoms); ++i)
    text += (i == 0 ? "" : ", ") + atoms[i].text();
  if (atoms.size() > kMaxAtoms) text += fmt::format(" and {} more", atoms.size() - kMaxAtoms);
  return text;
}

Doubt doubtAbout(const Rule& rule, const Group& group, std::string reason) {
  Doubt doubt;
  doubt.key = rule.key(group.options.front().atom);
  for (const Group::Option& option : group.options)
    doubt.atoms.push_back(option.atom);
  doubt.unknown = rule.unknown;
  doubt.reason = std::move(reason);
  return doubt;
}

std::string nowhere(const Group& group, std::size_t nearest, double distance) {
  const std::string places =
      listed(group.options, [](const Group::Option& option) { return option.place; });
  return fmt::format("{} is in none of {}; the nearest, {}, is {:.2f} m away", group.subject,
                     places, group.options[nearest].place, distance);
}

/// Any of the probes makes the atom true, even where others are unknown.
void decide(const Rule& rule, const Group& group, const Look& look, std::vector<bool>& held,
            Observation& seen) {
  const Group::Option& option = group.options.front();
  bool holds = false;
  std::string trouble;
  for (std::size_t i = 0; i < option.probes.size(); ++i) {
    const Probe& probe = option.probes[i];
    std::string why = look.trouble(probe);
    if (!why.empty()) {
      trouble = std::move(why);
      continue;
    }
    held[i] = look.distance(probe) <= (held[i] ? rule.margin : 0);
    holds = holds || held[i] != probe.negated;
  }
  if (holds) {
    seen.holds.insert(option.atom);
  } else if (!trouble.empty()) {
    seen.doubts.push_back(doubtAbout(rule, group, std::move(trouble)));
  }
}

/// The region it was in, until it is left by more than the margin; else the one it is deepest in.
void decideOne(const Rule& rule, const Group& group, const Look& look,
               std::optional<std::size_t>& was_in, Observation& seen) {
  std::vector<double> distances;
  for (const Group::Option& option : group.options) {
    std::string trouble = look.trouble(option.probes.front());
    if (!trouble.empty()) {
      seen.doubts.push_back(doubtAbout(rule, group, std::move(trouble)));
      return;
    }
    distances.push_back(look.distance(option.probes.front()));
  }
  const auto nearest = static_cast<std::size_t>(
      std::min_element(distances.begin(), distances.end()) - distances.begin());
  if (was_in && distances[*was_in] > rule.margin) was_in.reset();
  if (!was_in && (distances[nearest] <= 0 || rule.otherwise == Otherwise::Nearest))
    was_in = nearest;
  if (was_in) {
    seen.holds.insert(group.options[*was_in].atom);
  } else if (rule.otherwise == Otherwise::Unknown) {
    seen.doubts.push_back(doubtAbout(rule, group, nowhere(group, nearest, distances[nearest])));
  } else if (rule.otherwise == Otherwise::Object) {
    GroundName other = group.options.front().atom;
    other.arguments[rule.slot] = rule.otherwise_object;
    seen.holds.insert(std::move(other));
  }
}

}  // namespace

std::vector<GroundName> Observation::unknown() const {
  std::vector<GroundName> atoms;
  for (const Doubt& doubt : doubts) {
    if (doubt.unknown == Unknown::Fail)
      atoms.insert(atoms.end(), doubt.atoms.begin(), doubt.atoms.end());
  }
  return atoms;
}

std::string Observation::unknownFactsMessage() const {
  std::string text;
  std::size_t named = 0;
  std::size_t all = 0;
  for (const Doubt& doubt : doubts) {
    if (doubt.unknown != Unknown::Fail) continue;
    if (++all > kMaxDoubts) continue;
    ++named;
    text += fmt::format("{}{}: {}", text.empty() ? "nobody can tell " : "; nor ",
                        listOf(doubt.atoms), doubt.reason);
  }
  if (all > named) text += fmt::format("; nor {} more", all - named);
  return text;
}

void Observation::overlay(std::set<GroundName>& atoms) const {
  if (!rules) return;
  std::set<GroundName> trusted;
  for (const Doubt& doubt : doubts) {
    if (doubt.unknown == Unknown::TrustFile) trusted.insert(doubt.key);
  }
  for (auto atom = atoms.begin(); atom != atoms.end();) {
    const Rule* const owner = rules->ownerOf(*atom);
    const bool stays = owner == nullptr || trusted.count(owner->key(*atom)) > 0;
    atom = stays ? std::next(atom) : atoms.erase(atom);
  }
  atoms.insert(holds.begin(), holds.end());
}

bool Observation::tellsTheSame(const Observation& other) const {
  const auto same = [](const Doubt& a, const Doubt& b) { return a.key == b.key; };
  return rules == other.rules && holds == other.holds &&
         std::equal(doubts.begin(), doubts.end(), other.doubts.begin(), other.doubts.end(), same);
}

Observer::Observer(std::shared_ptr<const Rules> rules) : rules_(std::move(rules)) {
  for (const Rule& rule : rules_->rules()) {
    auto& memories = memories_.emplace_back();
    for (const Group& group : rule.groups)
      memories.push_back({std::vector<bool>(group.options.front().probes.size(), false), {}});
  }
}

Observation Observer::observe(const std::vector<Sighting>& sightings) {
  Observation seen;
  seen.rules = rules_;
  for (std::size_t i = 0; i < rules_->rules().size(); ++i) {
    const Rule& rule = rules_->rules()[i];
    const Look look(*rules_, rule, sightings);
    for (std::size_t j = 0; j < rule.groups.size(); ++j) {
      const Group& group = rule.groups[j];
      if (rule.exactly_one) {
        decideOne(rule, group, look, memories_[i][j].region, seen);
      } else {
        decide(rule, group, look, memories_[i][j].held, seen);
      }
    }
  }
  return seen;
}

}  // namespace goal_alignment::spatial_facts
