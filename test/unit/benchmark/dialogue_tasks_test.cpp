// SPDX-License-Identifier: BSD-3-Clause
#include "generators/dialogue_tasks.h"

#include <gtest/gtest.h>

namespace goal_alignment::benchmarks {
namespace {

using session::AnswerKind;
using session::OutcomeCode;

struct Ending {
  OutcomeCode code;
  std::size_t questions;
};

Ending endingOf(const session::Input& input, AnswerKind always) {
  session::Session session({});
  session.begin(input);
  while (session.step() != session::State::Done) {
    if (session.state() == session::State::AwaitingAnswer)
      session.answer(session.question()->fluents, always, "test");
  }
  return {session.outcome().code, session.questions().size()};
}

TEST(SweptRooms, areEachAskedAbout) {
  const Ending ending = endingOf(sweptRooms(3), AnswerKind::No);
  EXPECT_EQ(ending.code, OutcomeCode::Success);
  EXPECT_EQ(ending.questions, 3U);
}

TEST(SeatedGuests, canNotAllBeSeated) {
  EXPECT_EQ(endingOf(seatedGuests(4), AnswerKind::Yes).code, OutcomeCode::ExpectationUnachievable);
  EXPECT_EQ(endingOf(seatedGuests(4), AnswerKind::No).code, OutcomeCode::Success);
}

TEST(SwappedTiles, canNotBePutInOrder) {
  EXPECT_EQ(endingOf(swappedTiles(3), AnswerKind::Yes).code, OutcomeCode::ExpectationUnachievable);
  EXPECT_EQ(endingOf(swappedTiles(3), AnswerKind::No).code, OutcomeCode::Success);
}

TEST(TasksOfModelsThatAgree, needNoQuestion) {
  for (const auto& input : {wideAction(3), carriedBalls(2)}) {
    const Ending ending = endingOf(input, AnswerKind::Yes);
    EXPECT_EQ(ending.code, OutcomeCode::Success);
    EXPECT_EQ(ending.questions, 0U);
  }
}

TEST(LongText, isReadToItsEnd) {
  EXPECT_EQ(endingOf(longText(10), AnswerKind::No).code, OutcomeCode::Success);
}

}  // namespace
}  // namespace goal_alignment::benchmarks
