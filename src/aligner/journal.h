// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"

namespace goal_alignment::aligner {

/// One answer as it is remembered.
struct JournalAnswer {
  Literal fluent;
  session::AnswerKind kind = session::AnswerKind::No;  ///< never Decline
  std::string answered_by;
  ros::Time at;
};

/// What of a task its answers hold for, whatever the robot can do or finds: D^H, I^H, π^H, G^H, the
/// person, and the robot that asked, by its node's name. Equal tasks have equal keys, across
/// restarts and versions. G^H is the goal given, or else that of the human's problem with all its
/// conditions, whose text is part of the key. What has become so for the person since that file was
/// written is not: the answers still say what they want.
std::string journalKey(const session::Input& input, const std::string& person,
                       const std::string& robot);

/// Answers on disk, so that a dialogue that was broken off, by a cancel or by a crash, goes on
/// where it was: one JSON file a task, replaced as a whole, so that a reader finds an old or a new
/// one but never half of one. A folder that can't be written to and a file that can't be read are
/// complained of, and nothing else happens. Thread-safe.
class Journal {
 public:
  /// Takes one line for people.
  using ErrorCallback = std::function<void(const std::string&)>;

  Journal(std::string folder, ErrorCallback complain);

  /// The task whose answers are written from now on, in this session, and those it has on record.
  /// Entries that nobody touched for `expiry` seconds are deleted first; with expiry 0 nothing is
  /// read or written. A damaged entry is renamed to `….damaged`.
  std::vector<JournalAnswer> open(const std::string& key, const std::string& session_id,
                                  double expiry);

  /// Answers as soon as they are accepted, before the session knows of them: each stands for any
  /// earlier one, until write() brings it, too. Nothing where the session is another by now, or has
  /// come to its outcome.
  void add(const std::string& session_id, const std::vector<JournalAnswer>& answers);

  /// All answers of the session, whenever it has taken new ones, or those that are to count later.
  void write(const std::vector<JournalAnswer>& answers);

  /// The task has come to its outcome.
  void drop();

  /// What ~forget asks for: the entry goes, and nothing more is written until the next open().
  /// False where no task was opened yet.
  bool forget();

  /// What went wrong last, until it goes well again; empty: nothing.
  std::string lastError() const;

 private:
  std::string file() const;
  void replace();
  std::vector<JournalAnswer> read();
  void expire(double expiry);
  void report(const std::string& error);

  const std::string folder_;
  const ErrorCallback report_error_;
  mutable std::mutex mutex_;  // guards all below
  std::string key_;
  std::string session_id_;
  bool writing_ = false;
  bool decided_ = false;                        // since the last write()
  std::vector<JournalAnswer> answers_;          // of the session
  std::map<Literal, JournalAnswer> not_taken_;  // accepted, but not by the session yet
  std::string last_error_;
};

}  // namespace goal_alignment::aligner
