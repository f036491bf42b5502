// SPDX-License-Identifier: BSD-3-Clause
#include "md5.h"

#include <boost/algorithm/hex.hpp>
#include <boost/uuid/detail/md5.hpp>
#include <iterator>

namespace goal_alignment::any_message {

std::string md5Of(const std::string& text) {
  boost::uuids::detail::md5 hash;
  hash.process_bytes(text.data(), text.size());
  boost::uuids::detail::md5::digest_type digest;
  hash.get_digest(digest);
  // Words or bytes by Boost's version; in memory they are the digest's bytes in their order.
  const auto* bytes = reinterpret_cast<const unsigned char*>(&digest);
  std::string digits;
  boost::algorithm::hex_lower(bytes, bytes + sizeof digest, std::back_inserter(digits));
  return digits;
}

}  // namespace goal_alignment::any_message
