// SPDX-License-Identifier: BSD-3-Clause
#include "families.h"

#include <stdexcept>

namespace goal_alignment::benchmarks {
namespace {

Models shortOfCharge(int size, RandomSource& /*random*/) {
  return courier(size, 0);
}

}  // namespace

const std::vector<MonotoneDnf>& families() {
  static const std::vector<MonotoneDnf> all = {
      {"crates", crates, true, {4, 6, 8, 10, 12}},
      {"parcels", parcels, true, {2, 4, 6, 8, 12}},
      {"lifts", lifts, true, {2, 4, 6, 8, 10}},
      {"probes", probes, true, {2, 4, 6, 8, 10}},
      {"household", household, true, {8, 16, 32, 64, 128}},
      {"trolley", trolley, true, {2, 4, 8, 16, 32}, true},
      {"home", home, true, {4, 8, 16, 32, 64}, true},
      {"pegs", pegs, false, {3, 4, 5, 6, 7}},
      {"courier", shortOfCharge, false, {4, 8, 16, 32, 64}},
      {"guests", guests, false, {2, 3, 4, 5, 6}},
  };
  return all;
}

const MonotoneDnf& familyCalled(const std::string& name) {
  std::string known;
  for (const MonotoneDnf& family : families()) {
    if (family.name == name) return family;
    known += " " + family.name;
  }
  throw std::invalid_argument("no family " + name + "; there are" + known);
}

}  // namespace goal_alignment::benchmarks
