// SPDX-License-Identifier: BSD-3-Clause
#include "md5.h"

#include <fmt/format.h>

#include <boost/uuid/detail/md5.hpp>

namespace goal_alignment::any_message {

std::string md5Of(const std::string& text) {
  boost::uuids::detail::md5 hash;
  hash.process_bytes(text.data(), text.size());
  boost::uuids::detail::md5::digest_type digest;
  hash.get_digest(digest);
  // Four numbers, or in newer Boosts sixteen, whose digits follow one another.
  std::string digits;
  for (const auto part : digest)
    digits += fmt::format("{:0{}x}", part, 2 * sizeof part);
  return digits;
}

}  // namespace goal_alignment::any_message
