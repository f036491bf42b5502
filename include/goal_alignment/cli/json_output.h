// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::cli {

/// Keeps the fields in the order in which they are documented.
using Json = nlohmann::ordered_json;

Json texts(const std::vector<Literal>& literals);
Json texts(const std::vector<GroundName>& plan);

/// What `hagl align --json` prints.
Json toJson(const session::Session& session);

/// `outcome`, `code` and `message` alone: for what failed before there was a session's result.
Json toJson(const session::Outcome& outcome);

/// On standard output. Bytes that are no UTF-8, as the names of files may have, become U+FFFD.
void print(const Json& json);

}  // namespace goal_alignment::cli
