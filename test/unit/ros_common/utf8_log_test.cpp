// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/utf8_log.h"

#include <gtest/gtest.h>
#include <langinfo.h>

#include <clocale>
#include <cstdlib>

namespace goal_alignment::ros_common {
namespace {

TEST(Utf8Log, lettersArriveWhateverTheEnvironmentSays) {
  setenv("LC_ALL", "C", 1);
  std::setlocale(LC_ALL, "C");
  ASSERT_STRNE(nl_langinfo(CODESET), "UTF-8");
  logInUtf8();
  EXPECT_STREQ(nl_langinfo(CODESET), "UTF-8");
  EXPECT_STREQ(std::localeconv()->decimal_point, ".");
  unsetenv("LC_ALL");
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace goal_alignment::ros_common
