// SPDX-License-Identifier: BSD-3-Clause
#include "measure/report.h"

#include <gtest/gtest.h>

#include <cmath>

namespace goal_alignment::benchmarks {
namespace {

Record call(const std::string& status, double operators, double total) {
  Record record;
  record.set("suite", std::string("crates"));
  record.set("kind", std::string("first"));
  record.set("status", status);
  record.set("operators", operators);
  record.set("total", total);
  record.set("checks", std::size_t{1});
  record.set("checks_unknown", std::size_t{status == "solved" ? 0U : 1U});
  return record;
}

TEST(Report, findsTheExponentOfAPower) {
  const std::vector<Record> square = {call("solved", 10, 1), call("solved", 20, 4),
                                      call("solved", 40, 16), call("limit: time", 80, 1)};
  EXPECT_NEAR(growthExponent(square, "operators", "total"), 2, 1e-3);
  EXPECT_TRUE(std::isnan(growthExponent({square[0], square[0]}, "operators", "total")));
}

TEST(Report, countsWorkThatWasKilledAsAnUnknownCheck) {
  Record killed;
  killed.set("status", std::string("killed: time"));
  EXPECT_DOUBLE_EQ(shareOfChecksUnknown({call("solved", 1, 1), call("limit: time", 1, 1),
                                         call("solved", 1, 1), killed}),
                   0.5);
  EXPECT_EQ(shareOfChecksUnknown({}), 0);
}

TEST(Report, saysTheHeadlineAndTheGrowth) {
  const std::string text =
      summary({call("solved", 10, 1), call("solved", 20, 2), call("solved", 40, 4)});
  EXPECT_NE(text.find("**0.0 %** (0 of 3)"), std::string::npos) << text;
  EXPECT_NE(text.find("| first | crates | operators | ×4 | ×4 | 1.00 |"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace goal_alignment::benchmarks
