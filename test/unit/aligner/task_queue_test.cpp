// SPDX-License-Identifier: BSD-3-Clause
#include "aligner/task_queue.h"

#include <gtest/gtest.h>

namespace goal_alignment::aligner {
namespace {

using Queue = TaskQueue<int>;

Queue::Entry entry(int ticket, const std::string& identity) {
  Queue::Entry made;
  made.shown.goal_id = "goal " + std::to_string(ticket);
  made.shown.since = ros::Time(ticket);
  made.identity = identity;
  made.ticket = ticket;
  return made;
}

std::vector<int> ticketsOf(const std::vector<Queue::Entry>& entries) {
  std::vector<int> tickets;
  for (const Queue::Entry& each : entries)
    tickets.push_back(each.ticket);
  return tickets;
}

std::vector<int> emptied(Queue& queue) {
  return ticketsOf(queue.takeAll([](const Queue::Entry&) { return true; }));
}

Queue filled() {
  Queue queue;
  for (const int ticket : {1, 2, 3, 4})
    queue.add(entry(ticket, "task " + std::to_string(ticket)));
  return queue;
}

TEST(TaskQueue, isFullWithFour) {
  Queue queue;
  for (const int ticket : {1, 2, 3, 4}) {
    EXPECT_FALSE(queue.isFull());
    EXPECT_FALSE(queue.add(entry(ticket, std::to_string(ticket))));
  }
  EXPECT_TRUE(queue.isFull());
}

TEST(TaskQueue, theFirstToComeIsTheFirstToGo) {
  Queue queue = filled();
  queue.addFirst(entry(5, "task 5"));
  std::vector<int> order;
  while (const auto first = queue.takeFirst())
    order.push_back(first->ticket);
  EXPECT_EQ(order, (std::vector<int>{5, 1, 2, 3, 4}));
  EXPECT_TRUE(queue.empty());
}

TEST(TaskQueue, anEqualTaskTakesThePlaceOfTheOneThatWaits) {
  Queue queue = filled();
  const auto replaced = queue.add(entry(9, "task 2"));
  ASSERT_TRUE(replaced);
  EXPECT_EQ(replaced->ticket, 2);
  const auto shown = queue.shown();
  ASSERT_EQ(shown.size(), 4U);
  EXPECT_EQ(shown[1].goal_id, "goal 9");
  EXPECT_EQ(shown[1].since, ros::Time(2)) << "it has waited since then";
  EXPECT_EQ(emptied(queue), (std::vector<int>{1, 9, 3, 4}));
}

TEST(TaskQueue, whatFitsIsTakenOutAndTheRestKeepsItsOrder) {
  Queue queue = filled();
  EXPECT_TRUE(queue.holds("task 3"));
  EXPECT_EQ(ticketsOf(queue.takeAll([](const Queue::Entry& each) { return each.ticket % 2 == 1; })),
            (std::vector<int>{1, 3}));
  EXPECT_FALSE(queue.holds("task 3"));
  EXPECT_TRUE(queue.takeAll([](const Queue::Entry&) { return false; }).empty());
  EXPECT_EQ(emptied(queue), (std::vector<int>{2, 4}));
  EXPECT_FALSE(queue.takeFirst());
}

}  // namespace
}  // namespace goal_alignment::aligner
