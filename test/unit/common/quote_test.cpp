// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/quote.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>

namespace goal_alignment {
namespace {

bool isUtf8(const std::string& text) {
  try {
    nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

TEST(InQuotes, ShortensWhatNobodyWouldRead) {
  EXPECT_EQ(inQuotes(""), "''");
  EXPECT_EQ(inQuotes("on"), "'on'");
  EXPECT_EQ(inQuotes(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(inQuotes(std::string(100000, 'x')), "'" + std::string(60, 'x') + "…'");
}

TEST(InQuotes, CutsNoCharacter) {
  EXPECT_EQ(inQuotes(std::string(59, 'x') + "ü"), "'" + std::string(59, 'x') + "…'");
  EXPECT_EQ(inQuotes("Küche"), "'Küche'");
}

TEST(InQuotes, EndsWhereUtf8Ends) {
  EXPECT_EQ(inQuotes("K\xfc"
                     "che"),
            "'K…'");
}

TEST(Utf8, KnowsTheEdgesOfUnicode) {
  for (const char* good : {"\x7f", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf",
                           "\xee\x80\x80", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_EQ(utf8Length(good, 4), std::string(good).size()) << good;
  }
  for (const char* bad : {"\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
                          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xc3("}) {
    EXPECT_EQ(utf8Length(bad, 4), 0U) << bad;
  }
}

RC_GTEST_PROP(Utf8, AgreesWithAnotherReader, (const std::string& bytes)) {
  RC_ASSERT((utf8Length(bytes, bytes.size()) == bytes.size()) == isUtf8(bytes));
  RC_ASSERT(isUtf8(inQuotes(bytes)));
}

}  // namespace
}  // namespace goal_alignment
