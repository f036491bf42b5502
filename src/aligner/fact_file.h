// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "goal_alignment/session/session.h"
#include "said_facts.h"

namespace goal_alignment::aligner {

/// What facts are said of: where one of these has changed, what was said before no longer holds.
struct FactScope {
  std::string world;  ///< a simulation that begins anew has another
  /// Digests of the four texts, in the order of session::Input.
  std::vector<std::string> models;

  static FactScope of(const session::Input& models, const std::string& world);
};

/// The facts of one robot on disk, so that a node that was restarted knows them: a JSON file beside
/// the journal, replaced as a whole. A damaged one is set aside, one that can't be written is
/// complained of, and nothing else happens. Thread-safe.
class FactFile {
 public:
  /// Takes one line for people.
  using ErrorCallback = std::function<void(const std::string&)>;
  struct Kept {
    SaidFacts facts;
    double age = 0;    ///< seconds since the last of them was said
    std::string line;  ///< for people
  };

  /// `robot` is the name of its node.
  FactFile(const std::string& folder, std::string robot, ErrorCallback complain);

  /// What was kept and still holds. What is older than `expiry` seconds, or of other models, is
  /// complained of and left out; what is of another world is left out, and the line alone says so.
  /// With expiry 0 nothing is read here, or written later.
  std::optional<Kept> open(const FactScope& scope, double expiry);

  /// What the facts are said of from now on. Writes nothing.
  void setScope(const FactScope& scope);

  /// All facts; none: the file goes. Nothing before open().
  void write(const SaidFacts& facts);

  /// What went wrong last, until it goes well again; empty: nothing.
  std::string lastError() const;

 private:
  std::optional<Kept> read(const FactScope& scope, double expiry);
  void report(const std::string& error);

  const std::string robot_;
  const std::string file_;
  const ErrorCallback report_error_;
  mutable std::mutex mutex_;  // guards all below
  FactScope scope_;
  bool writing_ = false;
  std::string last_error_;
};

/// "5 min"; for people.
std::string spokenAge(double seconds);

}  // namespace goal_alignment::aligner
