// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// roscpp cuts all connections as soon as a node is told to end, so that nobody could be told how
/// their goal ends, and of SIGTERM it does not hear. A node that has last words uses these.
namespace goal_alignment::ros_common {

/// ros::init(), but SIGINT, SIGTERM and `rosnode kill` only end waitForShutdownRequest().
void initWithDeferredShutdown(int& argc, char** argv, const char* default_name);

void waitForShutdownRequest();

/// For a node without last words: SIGTERM ends it as SIGINT does. After ros::init().
void shutDownOnSigterm();

/// Waits, not for long, until what was published is on its way.
void flushPublished();

}  // namespace goal_alignment::ros_common
