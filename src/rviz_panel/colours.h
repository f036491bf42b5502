// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QColor>
#include <QPalette>
#include <cstdint>

/// Colours that can be read on the palette at hand, be it light or dark.
namespace goal_alignment::rviz_panel {

enum class Tone { Plain, Muted, Accent, Good, Bad, Warning };

QColor colourOf(Tone tone, const QPalette& palette);
/// The background of a card of this tone.
QColor tintOf(Tone tone, const QPalette& palette);
/// Of a candidate's state.
Tone toneOf(std::uint8_t candidate_state);

}  // namespace goal_alignment::rviz_panel
