// SPDX-License-Identifier: BSD-3-Clause
#include "task_repeats.h"

#include <iterator>

namespace goal_alignment::aligner {
namespace {

constexpr std::chrono::milliseconds kPause{1500};  // a rate of 1 Hz is no pause
constexpr std::chrono::seconds kToldAgainAfter{60};
constexpr unsigned kCopiesOfAWish = 2;                   // a person may press twice,
constexpr std::chrono::milliseconds kPressedAgain{300};  // but not so fast

}  // namespace

TaskRepeats::Verdict TaskRepeats::judge(const std::string& publisher, const std::string& identity,
                                        bool under_way, Clock::time_point now) {
  forgetOld(now);
  const auto [found, is_new] = series_.try_emplace({publisher, identity});
  Series& series = found->second;
  if (is_new) series.told = now - kToldAgainAfter;
  const bool begins = is_new || now - series.last > kPause;
  if (begins) {
    series.copies = 0;
    series.merged = false;
  }
  const bool too_fast = !begins && now - series.last < kPressedAgain;
  series.last = now;
  ++series.copies;
  const bool may_be_wanted = series.copies <= kCopiesOfAWish && !too_fast;
  if (!under_way && !series.merged && may_be_wanted) return Verdict::Wanted;
  series.merged = true;
  if (now - series.told < kToldAgainAfter) return Verdict::Repeated;
  series.told = now;
  return Verdict::RepeatedToTell;
}

void TaskRepeats::forgetOld(Clock::time_point now) {
  for (auto series = series_.begin(); series != series_.end();) {
    const bool old = now - series->second.last > kToldAgainAfter;
    series = old ? series_.erase(series) : std::next(series);
  }
}

}  // namespace goal_alignment::aligner
