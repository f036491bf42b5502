// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/phrasing/folding.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace goal_alignment::phrasing {
namespace {

TEST(Folding, LatinLettersLoseCaseAndAccents) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", ""},
      {"Yes", "yes"},
      {"Grüße", "grusse"},
      {"GRÜSSE", "grusse"},
      {"GRÜẞE", "grusse"},
      {"crème brûlée", "creme brulee"},
      {"CRÈME BRÛLÉE", "creme brulee"},
      {"Łódź, Ærø, Þór, Œuvre", "lodz, aero, thor, oeuvre"},
      {"ŞIŞLİ şapka ğ", "sisli sapka g"},
      {"Đặng Trần Ửng", "dang tran ung"},
      {"× ÷ 12 'n'", "× ÷ 12 'n'"},
  };
  for (const auto& [text, plain] : table)
    EXPECT_EQ(folded(text), plain);
}

TEST(Folding, DecomposedLettersAreTheSame) {
  EXPECT_EQ(folded("Gru\u0308n"), folded("GRÜN"));
  EXPECT_EQ(folded("cafe\u0301"), folded("Café"));
  EXPECT_EQ(folded("e\u0302\u0323"), folded("ệ")) << "two marks on one letter";
}

TEST(Folding, EverythingElseStays) {
  for (const std::string text : {"Кухня", "\u0438\u0306", "茶", "\u0308", "😀"})
    EXPECT_EQ(folded(text), text);
  EXPECT_EQ(folded("\xff"
                   "A\xc3"),
            "\xff"
            "a\xc3")
      << "what is no UTF-8";
}

}  // namespace
}  // namespace goal_alignment::phrasing
