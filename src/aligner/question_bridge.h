// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "goal_alignment/AlignmentState.h"
#include "goal_alignment/Answer.h"
#include "goal_alignment/common/ground_name.h"
#include "goal_alignment/session/session.h"
#include "question_ids.h"

namespace goal_alignment::aligner {

/// An answer that was accepted and waits for the solver thread.
struct AcceptedAnswer {
  std::vector<Literal> fluents;
  session::AnswerKind kind = session::AnswerKind::No;
  std::string answered_by;
  std::uint32_t question_id = 0;  ///< the open question it was given to; 0: volunteered or revised
  ros::Time at = {};              ///< when it was accepted, on ROS's clock
};

/// Where answers meet questions. Who names the open question's id and says YES to some of its group
/// says NO to the rest; what is volunteered, with id 0, says nothing of others. Callback threads
/// submit answers and learn at once whether they are taken; the solver thread opens questions,
/// waits, and takes the answers out. What is refused is decided against a snapshot of the
/// candidates, on which answers already accepted count, so that of two answerers who race one is
/// told that they were too late. A question that is put again after silence has a new id; who still
/// answers to an earlier one means the same question.
class QuestionBridge {
 public:
  using Clock = std::chrono::steady_clock;
  /// Hears of accepted answers, in the order of their acceptance, before their giver does and
  /// before they are taken; on the giver's thread.
  using Keep = std::function<void(const std::string& session_id,
                                  const std::vector<AcceptedAnswer>& answers)>;

  explicit QuestionBridge(QuestionIds ids, Keep keep = {},
                          std::function<Clock::time_point()> now = Clock::now);

  // Of the solver thread.

  /// A session begins, whose candidates are not known until update(), or goes on, with those it has
  /// and the answers accepted since they were last taken.
  void beginSession(const std::string& session_id);
  /// Nothing can be answered until the next session, only revised. Answers not taken are kept for
  /// when this one goes on, but for DECLINE, which ends nothing any more.
  void endSession();
  /// The same unless an accepted answer still waits to be taken: then false.
  bool endSessionIfIdle();
  /// The candidates as the session sees them, after every step.
  void update(const session::Snapshot& snapshot);
  /// Opens a question and returns its id; 0 and nothing, as long as an accepted answer waits to be
  /// taken: it may be the answer to this very question. Where the last one was about the same
  /// fluents and nobody answered it, this is that one put again.
  std::uint32_t open(const std::vector<Literal>& fluents);
  void close();
  /// Waits for the keeping of those that were accepted a moment ago.
  std::vector<AcceptedAnswer> take();
  /// All that was taken stands in the state that was published last.
  void markShown();
  enum class Wake { Answer, Interrupt, News, TimedOut };
  /// Waits in wall time for an answer, for interrupt(), for wakeUp(), or until the deadline.
  Wake wait(Clock::time_point deadline);

  // Of any thread.

  /// Ends the wait under way, or the next one.
  void interrupt();
  /// Something else than an answer needs the solver thread: ends the wait under way, or the next.
  void wakeUp();
  session::SubmitResult submit(const Answer::Request& request);
  /// For ~revise_answer: changes earlier answers or gives first ones, also after the outcome.
  struct Revision {
    session::SubmitResult receipt;
    std::string continue_session;  ///< where the session has ended: which one has to go on
  };
  Revision revise(const Answer::Request& request);
  /// The answers of the session that were accepted since a state was published, in their order.
  struct Unshown {
    std::string session_id;
    std::vector<AcceptedAnswer> answers;
    /// To one that was published after they were asked for, or before.
    void addTo(AlignmentState& state) const;
  };
  Unshown unshown() const;
  /// 0: none is open.
  std::uint32_t openId() const;
  /// Why answers were refused since the open question was put first, or since one was accepted, the
  /// last ones, each once, as one text; empty: none was.
  std::string refusals() const;

 private:
  struct OpenQuestion {
    std::uint32_t id = 0;
    std::set<std::uint32_t> earlier_ids;  // of the same question, put before in vain
    std::set<Literal> fluents;
    bool replaced_another = false;
    Clock::time_point opened;
  };

  /// Lets go of mutex_, but not of keeping_.
  void keep(std::unique_lock<std::mutex>& lock, const std::vector<AcceptedAnswer>& answers) const;

  // All below need mutex_. Refusals say why not; empty: nothing speaks against it.
  std::string refusalOf(const Answer::Request& request, const std::vector<Literal>& fluents) const;
  std::string refusalOfQuestion(const Answer::Request& request) const;
  std::string refusalOfFluents(const std::vector<Literal>& fluents, std::uint32_t question_id,
                               bool revising) const;
  std::string refusalOfFluent(const Literal& fluent, bool revising) const;
  bool isOpen(std::uint32_t id) const;
  session::SubmitResult refuse(const std::string& why_not);
  std::vector<Literal> unanswered() const;
  void accept(AcceptedAnswer answer);
  void count(const AcceptedAnswer& answer);
  void closeOpen(bool answered);

  const Keep keep_;
  const std::function<Clock::time_point()> now_;
  std::mutex keeping_;  // of who accepts answers, until they are kept; before mutex_
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  QuestionIds ids_;
  bool under_way_ = false;
  bool interrupted_ = false;
  bool woken_ = false;
  std::string session_id_;
  std::optional<OpenQuestion> open_;
  std::string last_session_;  // of the question before
  std::set<Literal> last_fluents_;
  std::set<std::uint32_t> last_ids_;
  bool last_answered_ = false;
  std::optional<Clock::time_point> last_closed_;
  bool candidates_known_ = false;
  std::set<Literal> specified_;
  std::map<Literal, session::CandidateState> candidates_;
  std::vector<AcceptedAnswer> accepted_;
  std::vector<AcceptedAnswer> taken_;  // since a state was published
  std::vector<std::string> refusals_;
};

}  // namespace goal_alignment::aligner
