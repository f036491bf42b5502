// SPDX-License-Identifier: BSD-3-Clause
#include "search/events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "goal_alignment/common/exceptions.h"
#include "samples.h"
#include "search/group_order.h"

namespace goal_alignment::search {
namespace {

using heuristics::MutexGroups;
using task::Task;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// A token on three places, and a lamp that is on or not.
Task tokenAndLamp() {
  Task task;
  task.facts.resize(4);
  task.initial = {0};
  return task;
}

std::vector<Event> eventsOf(const Task& task) {
  return makeEvents(task, MutexGroups(task, {{0, 1, 2}, {3}}), {});
}

TEST(Events, NameWhatTheyNeedAndWhatTheyChange) {
  Task task = tokenAndLamp();
  task.operators.push_back({{"move", {}}, {0, 3}, {1}, {0}, 1});
  const std::vector<Event> events = eventsOf(task);
  ASSERT_EQ(events.size(), 1U);
  ASSERT_EQ(events[0].changes.size(), 2U);
  EXPECT_EQ(events[0].changes[0].pairs, (Pairs{{0, 1}}));
  EXPECT_EQ(events[0].changes[1].pairs, (Pairs{{0, 0}}));
}

TEST(Events, LeaveOutWhatChangesNothingOrCanNeverBe) {
  Task task = tokenAndLamp();
  task.operators.push_back({{"look", {}}, {0}, {0}, {}, 1});
  task.operators.push_back({{"be in two places", {}}, {0, 1}, {2}, {}, 1});
  task.operators.push_back({{"go to two places", {}}, {0}, {1, 2}, {0}, 1});
  EXPECT_TRUE(eventsOf(task).empty());
}

// on ∧ at 0: moves; otherwise the lamp goes on. Told apart: off; on and elsewhere, which changes
// nothing; on and at 0.
TEST(Events, SplitByWhichConditionalEffectsComeAbout) {
  Task task = tokenAndLamp();
  task.operators.push_back({{"switch", {}}, {}, {3}, {}, 1, {{{0, 3}, {1}, {0}}}});
  const std::vector<Event> events = eventsOf(task);
  std::size_t moving = 0;
  for (const Event& event : events) {
    if (event.changes[0].group != 0 || !event.changes[0].changes()) continue;
    ++moving;
    EXPECT_EQ(event.changes[0].pairs, (Pairs{{0, 1}}));
    EXPECT_EQ(event.changes[1].pairs, (Pairs{{0, 0}}));
  }
  EXPECT_EQ(moving, 1U);
  EXPECT_EQ(events.size(), 3U);
}

TEST(Events, ManyConditionsEndAtTheLimits) {
  Task task = samples::switches(30);
  task::Operator all = {{"all", {}}, {}, {}, {}, 1};
  for (task::FactId bit = 0; bit < 30; ++bit)
    all.conditional.push_back({{2 * bit}, {2 * bit + 1}, {2 * bit}});
  task.operators.push_back(all);
  const MutexGroups groups = heuristics::groupsFromInvariants(task, {});
  EXPECT_THROW(makeEvents(task, groups, Limits{}.withStates(10'000)), LimitReached);
}

TEST(GroupOrder, HoldsEveryGroupOnce) {
  const Task task = samples::switches(7);
  const MutexGroups groups = heuristics::groupsFromInvariants(task, {});
  const std::vector<Event> events = makeEvents(task, groups, {});
  const auto orders = groupOrders(7, events, {});
  ASSERT_FALSE(orders.empty());
  for (GroupOrder order : orders) {
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, (GroupOrder{0, 1, 2, 3, 4, 5, 6}));
  }
  CancelToken token;
  token.cancel();
  Limits limits;
  limits.cancel = &token;
  EXPECT_THROW(groupOrders(7, events, limits), LimitReached);
}

// A chain of groups, each touched with the next: by their numbers they are 17 levels apart all in
// all, 5 at least.
TEST(GroupOrder, PutsTogetherWhatEventsTouchTogether) {
  const std::vector<std::uint32_t> chain = {3, 0, 5, 1, 4, 2};
  std::vector<Event> events;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    Event event;
    event.changes = {{std::min(chain[i], chain[i + 1]), {{0, 1}}},
                     {std::max(chain[i], chain[i + 1]), {{0, 1}}}};
    events.push_back(event);
  }
  const GroupOrder order = groupOrders(chain.size(), events, {}).front();
  const auto level = [&](std::uint32_t group) {
    return std::find(order.begin(), order.end(), group) - order.begin();
  };
  std::ptrdiff_t apart = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    apart += std::abs(level(chain[i]) - level(chain[i + 1]));
  EXPECT_LE(apart, 10);
}

}  // namespace
}  // namespace goal_alignment::search
