// SPDX-License-Identifier: BSD-3-Clause
#include "colours.h"

#include "goal_alignment/Candidate.h"

namespace goal_alignment::rviz_panel {
namespace {

constexpr int kDarkBelow = 128;  // lightness of the background, 0 to 255

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < kDarkBelow;
}

QColor mixed(const QColor& a, const QColor& b, double share_of_b) {
  const auto mix = [&](int x, int y) { return qRound(x + (y - x) * share_of_b); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

}  // namespace

QColor colourOf(Tone tone, const QPalette& palette) {
  const bool dark = isDark(palette);
  switch (tone) {
    case Tone::Accent:
      return dark ? QColor(0x6c, 0xb2, 0xf7) : QColor(0x1b, 0x62, 0xb5);
    case Tone::Good:
      return dark ? QColor(0x74, 0xc9, 0x83) : QColor(0x1e, 0x7a, 0x37);
    case Tone::Bad:
      return dark ? QColor(0xf2, 0x8b, 0x82) : QColor(0xb3, 0x26, 0x1e);
    case Tone::Warning:
      return dark ? QColor(0xe8, 0xb5, 0x4d) : QColor(0x8f, 0x5a, 0x00);
    case Tone::Muted:
      return mixed(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.4);
    default:
      return palette.color(QPalette::Text);
  }
}

QColor tintOf(Tone tone, const QPalette& palette) {
  return mixed(palette.color(QPalette::Base), colourOf(tone, palette), 0.09);
}

Tone toneOf(std::uint8_t candidate_state) {
  switch (candidate_state) {
    case Candidate::SPECIFIED:
      return Tone::Plain;
    case Candidate::ASKED:
      return Tone::Accent;
    case Candidate::WANTED:
      return Tone::Good;
    case Candidate::NOT_WANTED:
      return Tone::Bad;
    case Candidate::OPEN:
    case Candidate::UNSURE:
      return Tone::Warning;
    default:
      return Tone::Muted;
  }
}

}  // namespace goal_alignment::rviz_panel
