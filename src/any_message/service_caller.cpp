// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/any_message/service_caller.h"

#include <ros/service.h>

#include <condition_variable>
#include <cstring>
#include <mutex>
#include <thread>
#include <utility>

namespace goal_alignment::any_message {
namespace {

constexpr std::chrono::milliseconds kLookPause{50};
constexpr std::chrono::seconds kMinLook{1};
constexpr std::chrono::seconds kPatienceAtTheEnd{2};
constexpr int kMaxCalls = 100;  // each is a thread and a socket
constexpr std::size_t kLengthPrefix = sizeof(std::uint32_t);

ros::SerializedMessage serialized(const Bytes& request) {
  const auto length = static_cast<std::uint32_t>(request.size());
  const boost::shared_array<std::uint8_t> buffer(new std::uint8_t[kLengthPrefix + request.size()]);
  std::memcpy(buffer.get(), &length, kLengthPrefix);
  if (!request.empty()) std::memcpy(buffer.get() + kLengthPrefix, request.data(), request.size());
  return {buffer, kLengthPrefix + request.size()};
}

Bytes contentOf(const ros::SerializedMessage& message) {
  const std::uint8_t* end = message.buf.get() + message.num_bytes;
  return message.buf ? Bytes(message.message_start, const_cast<std::uint8_t*>(end)) : Bytes();
}

}  // namespace

// One call, which its caller may have left.
struct ServiceCaller::Call {
  bool find();
  Reply make();
  void run();

  std::optional<ros::NodeHandle> node;  // gone with the call: roscpp must outlive it
  std::string service;
  std::string md5;
  Bytes request;
  Clock::time_point look_until;
  bool only_looks = false;

  std::mutex mutex;  // guards all below
  std::optional<Reply> reply;
  bool abandoned = false;
};

struct ServiceCaller::Shared {
  std::mutex mutex;  // guards the two below
  std::condition_variable changed;
  int calls = 0;
};

// False: nobody offers it, or nobody waits for the answer any more.
bool ServiceCaller::Call::find() {
  while (!ros::service::exists(service, false)) {
    if (Clock::now() >= look_until || !ros::ok()) return false;
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (abandoned) return false;
    }
    std::this_thread::sleep_for(kLookPause);
  }
  // A call that was abandoned while it looked must not be made.
  const std::lock_guard<std::mutex> lock(mutex);
  return !abandoned;
}

ServiceCaller::Reply ServiceCaller::Call::make() {
  if (!find()) return {Reply::Kind::NoServer, {}};
  if (only_looks) return {Reply::Kind::Answered, {}};
  // Persistent, since of other calls roscpp loses a response now and then (ros_comm issue 1976).
  ros::ServiceClientOptions options(service, md5, true, {});
  ros::ServiceClient client = node->serviceClient(options);
  ros::SerializedMessage response;
  if (!client.call(serialized(request), response, md5)) return {Reply::Kind::Failed, {}};
  return {Reply::Kind::Answered, contentOf(response)};
}

void ServiceCaller::Call::run() {
  Reply made = make();
  node.reset();
  const std::lock_guard<std::mutex> lock(mutex);
  reply = std::move(made);
}

ServiceCaller::ServiceCaller(ros::NodeHandle node, WaitPoint& wait)
    : node_(std::move(node)), shared_(std::make_shared<Shared>()), wait_(wait) {}

ServiceCaller::~ServiceCaller() {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  shared_->changed.wait_for(lock, kPatienceAtTheEnd, [this] { return shared_->calls == 0; });
}

// False: too many are under way.
bool ServiceCaller::start(const std::shared_ptr<Call>& call) {
  call->node = node_;
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    if (shared_->calls == kMaxCalls) return false;
    ++shared_->calls;
  }
  std::thread([shared = shared_, call] {
    call->run();
    const std::lock_guard<std::mutex> lock(shared->mutex);
    --shared->calls;
    shared->changed.notify_all();
  }).detach();
  return true;
}

ServiceCaller::Reply ServiceCaller::call(const std::string& service, const std::string& md5,
                                         const Bytes& request, const Limits& limits, On give_up) {
  auto call = std::make_shared<Call>();
  call->service = node_.resolveName(service);
  call->md5 = md5;
  call->request = request;
  call->look_until = std::min(deadlineIn(limits.patience), limits.end.wall());
  if (!start(call)) return {Reply::Kind::TooMany, {}};
  const auto isAnswered = [&] {
    const std::lock_guard<std::mutex> lock(call->mutex);
    return call->reply.has_value();
  };
  auto woken = give_up == On::Interrupt ? wait_.waitUntil(limits.end, isAnswered)
                                        : wait_.settleUntil(limits.end, isAnswered);
  if (woken == WaitPoint::Woken::Timeout && limits.cancel_timeout > 0)
    woken = wait_.waitUntil(deadlineIn(limits.cancel_timeout), isAnswered);
  const std::lock_guard<std::mutex> lock(call->mutex);
  if (call->reply) return *call->reply;
  call->abandoned = true;
  return {woken == WaitPoint::Woken::Interrupt ? Reply::Kind::Interrupted : Reply::Kind::TimedOut,
          {}};
}

bool ServiceCaller::isOffered(const std::string& service, Clock::time_point until) {
  auto call = std::make_shared<Call>();
  call->service = node_.resolveName(service);
  call->look_until = until;
  call->only_looks = true;
  if (!start(call)) return false;
  const auto isAnswered = [&] {
    const std::lock_guard<std::mutex> lock(call->mutex);
    return call->reply.has_value();
  };
  // It looks once in any case.
  wait_.waitUntil(std::max(until, Clock::now() + kMinLook), isAnswered);
  const std::lock_guard<std::mutex> lock(call->mutex);
  call->abandoned = true;
  return call->reply && call->reply->kind == Reply::Kind::Answered;
}

}  // namespace goal_alignment::any_message
