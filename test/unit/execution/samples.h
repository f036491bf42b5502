// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "unit/any_message/samples.h"

namespace goal_alignment::execution::test {

using any_message::test::faultOfCall;
using any_message::test::step;
using any_message::test::typesOf;

}  // namespace goal_alignment::execution::test
