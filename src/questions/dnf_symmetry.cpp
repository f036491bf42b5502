// SPDX-License-Identifier: BSD-3-Clause
#include "dnf_symmetry.h"

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <tuple>

namespace goal_alignment::questions {

namespace {

using Colours = std::array<std::uint64_t, kMaxBits>;

/// As far as this away candidates see what surrounds them.
constexpr int kRounds = 3;

/// One round: a candidate's colour takes in those of the sets around it.
void refine(const MonotoneDnf& dnf, CandidateMask all, Colours& colours) {
  Colours next{};
  for (const CandidateMask set : dnf) {
    std::uint64_t of_set = 0;
    for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
      of_set += spread(colours[firstBit(left)]);
    of_set = spread(of_set);
    for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
      next[firstBit(left)] += of_set;
  }
  for (CandidateMask left = all; left != 0; left = clearLowestBit(left)) {
    const std::size_t f = firstBit(left);
    colours[f] = spread(colours[f] ^ next[f]);
  }
}

/// What hangs together by common sets, as disjoint sets of candidates.
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

/// What a candidate is ordered by among its likes.
struct Place {
  std::size_t likes;  // the first bit as likely
  std::uint64_t of_component;
  std::size_t component;
  std::uint64_t colour;
  std::size_t candidate;
  bool operator<(const Place& other) const {
    return std::tie(likes, of_component, component, colour, candidate) <
           std::tie(other.likes, other.of_component, other.component, other.colour,
                    other.candidate);
  }
};

}  // namespace

DnfKey keyUpToNames(const MonotoneDnf& dnf, const Chances& p) {
  const CandidateMask all = dnf.all();
  if (!p.anyAlike(all)) return dnf.key();
  Colours colours;
  for (CandidateMask left = all; left != 0; left = clearLowestBit(left))
    colours[firstBit(left)] = p.firstAlike(firstBit(left));
  for (int round = 0; round < kRounds; ++round)
    refine(dnf, all, colours);
  boost::container::small_vector<Place, kMaxBits> places;
  for (const CandidateMask component : components(dnf)) {
    std::uint64_t of_component = 0;
    for (CandidateMask left = component; left != 0; left = clearLowestBit(left))
      of_component += spread(colours[firstBit(left)]);
    for (CandidateMask left = component; left != 0; left = clearLowestBit(left)) {
      const std::size_t f = firstBit(left);
      places.push_back({p.firstAlike(f), of_component, firstBit(component), colours[f], f});
    }
  }
  std::sort(places.begin(), places.end());
  std::array<CandidateMask, kMaxBits> renamed;
  for (std::size_t i = 0, next = 0; i < places.size(); ++i) {
    next = i > 0 && places[i - 1].likes == places[i].likes ? next + 1 : places[i].likes;
    renamed[places[i].candidate] = bitOf(next);
  }
  DnfKey key;
  for (const CandidateMask set : dnf) {
    CandidateMask with_new_names = 0;
    for (CandidateMask left = set; left != 0; left = clearLowestBit(left))
      with_new_names |= renamed[firstBit(left)];
    addTo(key, with_new_names);
  }
  return key;
}

}  // namespace goal_alignment::questions
