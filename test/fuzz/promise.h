// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "goal_alignment/pddl/exceptions.h"

/// What the targets share.
namespace goal_alignment::fuzz {

/// The core did something else than it says.
class Broken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

inline void promise(bool kept, const std::string& what) {
  if (!kept) throw Broken("broken promise: " + what);
}

/// What goes out to people goes in messages and JSON, which hold UTF-8 only.
inline void promiseReadable(const std::string& text) {
  try {
    nlohmann::json(text).dump();
  } catch (const nlohmann::json::type_error&) {
    throw Broken("broken promise: this is UTF-8: " + text);
  }
}

/// Readable, and no quotation of the whole input.
inline void promiseMessage(const std::string& message) {
  constexpr std::size_t kLongest = 2000;
  promise(message.size() <= kLongest, "a message is short");
  promiseReadable(message);
}

/// True where the text is read. Refusing it is as good, with a place; any other exception goes
/// through.
template <typename Read>
bool isRead(Read read) {
  try {
    read();
    return true;
  } catch (const pddl::InputError& refused) {
    promiseMessage(refused.what());
    promise(refused.position().line > 0, std::string("an error has a place: ") + refused.what());
    return false;
  }
}

}  // namespace goal_alignment::fuzz
