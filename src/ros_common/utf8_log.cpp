// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/ros_common/utf8_log.h"

#include <langinfo.h>

#include <clocale>
#include <string>

namespace goal_alignment::ros_common {

void logInUtf8() {
  std::setlocale(LC_CTYPE, "");
  if (std::string(nl_langinfo(CODESET)) != "UTF-8") std::setlocale(LC_CTYPE, "C.UTF-8");
}

}  // namespace goal_alignment::ros_common
