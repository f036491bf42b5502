// SPDX-License-Identifier: BSD-3-Clause
#include "dnf_symmetry.h"

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <tuple>

namespace goal_alignment::questions {

namespace {

using Colours = std::array<std::uint64_t, kMaxCandidates>;

/// How many sets away a candidate's surroundings still count.
constexpr int kRounds = 3;

/// One round: a candidate's colour takes in those of the sets around it.
void refine(const MonotoneDnf& dnf, CandidateMask all, Colours& colours) {
  Colours next{};
  for (const CandidateMask set : dnf) {
    std::uint64_t of_set = 0;
    for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
      of_set += spread(colours[firstCandidate(left)]);
    of_set = spread(of_set);
    for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
      next[firstCandidate(left)] += of_set;
  }
  for (CandidateMask left = all; left != 0; left = clearLowestBit(left)) {
    const std::size_t f = firstCandidate(left);
    colours[f] = spread(colours[f] ^ next[f]);
  }
}

/// The connected components: candidates that are linked by common sets.
boost::container::small_vector<CandidateMask, 16> components(const MonotoneDnf& dnf) {
  boost::container::small_vector<CandidateMask, 16> result;
  for (CandidateMask joined : dnf) {
    const auto rest = std::remove_if(result.begin(), result.end(), [&joined](CandidateMask other) {
      if ((other & joined) == 0) return false;
      joined |= other;
      return true;
    });
    result.erase(rest, result.end());
    result.push_back(joined);
  }
  return result;
}

/// What a candidate is ordered by among those as likely.
struct Place {
  std::size_t first_as_likely;  // the first candidate with the same chance
  std::uint64_t of_component;
  std::size_t component;
  std::uint64_t colour;
  std::size_t candidate;
  bool operator<(const Place& other) const {
    return std::tie(first_as_likely, of_component, component, colour, candidate) <
           std::tie(other.first_as_likely, other.of_component, other.component, other.colour,
                    other.candidate);
  }
};

}  // namespace

DnfKey keyUpToRenaming(const MonotoneDnf& dnf, const Chances& p) {
  const CandidateMask all = dnf.all();
  if (!p.anyEqual(all)) return dnf.key();
  Colours colours;
  for (CandidateMask left = all; left != 0; left = clearLowestBit(left))
    colours[firstCandidate(left)] = p.firstWithSameChance(firstCandidate(left));
  for (int round = 0; round < kRounds; ++round)
    refine(dnf, all, colours);
  boost::container::small_vector<Place, kMaxCandidates> places;
  for (const CandidateMask component : components(dnf)) {
    std::uint64_t of_component = 0;
    for (CandidateMask left = component; left != 0; left = clearLowestBit(left))
      of_component += spread(colours[firstCandidate(left)]);
    for (CandidateMask left = component; left != 0; left = clearLowestBit(left)) {
      const std::size_t f = firstCandidate(left);
      places.push_back(
          {p.firstWithSameChance(f), of_component, firstCandidate(component), colours[f], f});
    }
  }
  std::sort(places.begin(), places.end());
  std::array<CandidateMask, kMaxCandidates> renamed;
  for (std::size_t i = 0, next = 0; i < places.size(); ++i) {
    next = i > 0 && places[i - 1].first_as_likely == places[i].first_as_likely
               ? next + 1
               : places[i].first_as_likely;
    renamed[places[i].candidate] = maskOf(next);
  }
  DnfKey key;
  for (const CandidateMask set : dnf) {
    CandidateMask with_new_names = 0;
    for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
      with_new_names |= renamed[firstCandidate(left)];
    addTo(key, with_new_names);
  }
  return key;
}

}  // namespace goal_alignment::questions
