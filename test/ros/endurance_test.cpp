// SPDX-License-Identifier: BSD-3-Clause
// A node that runs for a week must not grow.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "aligner_calls.h"
#include "graph.h"

namespace goal_alignment::test {
namespace {

namespace fs = std::filesystem;

constexpr int kGoals = 1000;
constexpr int kWarmUp = 200;  // until buffers and pools have their size
constexpr int kCallsPerGoal = 10;
constexpr long kMaxGrowth = 8 * 1024;  // KiB
constexpr long kMaxMore = 10;          // connections that come and go; one lost a goal makes 800

struct Footprint {
  long resident = 0;  // KiB
  long threads = 0;
  long descriptors = 0;
};

// The newest question alone: after a thousand goals nobody wants to search them all.
class NewestQuestion {
 public:
  NewestQuestion()
      : subscriber_(node_.subscribe("/goal_alignment/question", 10, &NewestQuestion::hear, this)) {}

  std::uint32_t awaitAfter(std::uint32_t id) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(kPatience), [&] { return id_ > id; });
    return id_ > id ? id_ : 0;
  }

  std::uint32_t id() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return id_;
  }

 private:
  void hear(const Question::ConstPtr& question) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      id_ = std::max(id_, question->question_id);
    }
    changed_.notify_all();
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint32_t id_ = 0;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
};

class Endurance : public testing::Test {
 protected:
  Endurance() : align_(node_, "/goal_alignment/align") {}

  void SetUp() override {
    ASSERT_TRUE(eventually([this] { return align_.isServerConnected(); }));
    ASSERT_TRUE(isOffered("/goal_alignment/set_facts"));
    XmlRpc::XmlRpcValue response = callNode("/goal_alignment", "getPid");
    ASSERT_TRUE(response.valid());
    process_ = "/proc/" + std::to_string(static_cast<int&>(response[2]));
  }

  Footprint footprint() const {
    Footprint result;
    std::ifstream status(process_ + "/status");
    for (std::string key; status >> key;) {
      if (key == "VmRSS:") status >> result.resident;
      if (key == "Threads:") status >> result.threads;
      std::getline(status, key);
    }
    result.descriptors =
        std::distance(fs::directory_iterator(process_ + "/fd"), fs::directory_iterator());
    return result;
  }

  // One goal in two leads to a question; the services are called while it is open, or after.
  void serve(int number) {
    const bool asks = number % 2 == 0;
    const std::uint32_t before = questions_.id();
    align_.sendGoal(asks ? sweepHall() : sweepSilently());
    if (asks) {
      const std::uint32_t id = questions_.awaitAfter(before);
      ASSERT_NE(id, 0U);
      callServices();
      const int lost = lost_;
      ASSERT_TRUE(answer(id).accepted || lost_ > lost);
    }
    ASSERT_TRUE(waitForEnd(align_));
    ASSERT_EQ(align_.getResult()->outcome, AlignResult::SUCCESS);
    if (!asks) callServices();
  }

  // Over a connection of one call, as most clients do it, until its response arrives: some are lost
  // in roscpp's client, see callService(). All but ~answer may be called twice.
  template <typename Service>
  typename Service::Response call(const std::string& name,
                                  const typename Service::Request& request) {
    constexpr int kTries = 5;
    Service service;
    service.request = request;
    int lost = 0;
    while (!ros::service::call("/goal_alignment/" + name, service) && lost < kTries)
      ++lost;
    EXPECT_LT(lost, kTries) << name;
    lost_ += lost;
    return service.response;
  }

  Answer::Response answer(std::uint32_t id) {
    Answer::Request request;
    request.answer = Answer::Request::NO;
    request.question_id = id;
    return call<Answer>("answer", request);
  }

  void callServices() {
    static_assert(kCallsPerGoal == 10, "as many as below");
    Explain::Request why;
    why.fluents = {"(quiet hall)"};
    Validate::Request models;
    models.domain = "(define (domain d))";
    models.problem = "(define (problem p)";
    SetFacts::Request facts;
    facts.facts = {fluent("room", {"hall"})};
    for (int i = 0; i < 2; ++i) {
      EXPECT_FALSE(call<GetState>("get_state", {}).state.session_id.empty());
      EXPECT_FALSE(answer(4000000000U).accepted);
      EXPECT_TRUE(call<Explain>("explain", why).known);
      EXPECT_FALSE(call<Validate>("validate", models).valid);
      EXPECT_TRUE(call<SetFacts>("set_facts", facts).accepted);
    }
  }

  ros::NodeHandle node_;
  AlignClient align_;
  NewestQuestion questions_;
  std::string process_;
  int lost_ = 0;
};

TEST_F(Endurance, aThousandGoalsAndTenThousandCallsLeaveNoTrace) {
  for (int i = 0; i < kWarmUp; ++i)
    ASSERT_NO_FATAL_FAILURE(serve(i));
  const Footprint warm = footprint();
  for (int i = kWarmUp; i < kGoals; ++i)
    ASSERT_NO_FATAL_FAILURE(serve(i));
  const Footprint end = footprint();
  std::cout << "resident " << warm.resident << " -> " << end.resident << " KiB, threads "
            << warm.threads << " -> " << end.threads << ", descriptors " << warm.descriptors
            << " -> " << end.descriptors << ", responses lost " << lost_ << std::endl;
// A sanitizer keeps books on memory, and freed memory back; AddressSanitizer looks for leaks
// itself.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(end.resident - warm.resident, kMaxGrowth);
#endif
  EXPECT_LE(end.threads, warm.threads + kMaxMore);
  EXPECT_LE(end.descriptors, warm.descriptors + kMaxMore);
}

}  // namespace
}  // namespace goal_alignment::test
