// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/serialization.h>
#include <ros/service_traits.h>

#include <memory>
#include <optional>
#include <string>

#include "goal_alignment/any_message/message_codec.h"
#include "goal_alignment/any_message/wait_point.h"

namespace goal_alignment::any_message {

/// Calls services of any type, on threads that can be abandoned: roscpp's calls have no time-out.
class ServiceCaller {
 public:
  struct Reply {
    enum class Kind {
      Answered,     ///< `response` has the message
      Failed,       ///< the server refused the call, or died
      NoServer,     ///< nobody offers it
      TimedOut,     ///< no answer in time; the call is abandoned, whatever still becomes of it
      Interrupted,  ///< abandoned as well
      TooMany,      ///< abandoned calls that have not ended yet; this one was not made
    };
    Kind kind = Kind::Failed;
    Bytes response;
  };

  ServiceCaller(ros::NodeHandle node, WaitPoint& wait);
  /// After ros::shutdown(), which ends calls under way.
  ~ServiceCaller();
  ServiceCaller(const ServiceCaller&) = delete;
  ServiceCaller& operator=(const ServiceCaller&) = delete;

  /// What an interrupt does to a call: one that is short and has to be made is not abandoned.
  enum class On { Interrupt, End };

  /// How long things may take, in seconds, and the end of the whole.
  struct Limits {
    double patience = 0;        ///< for which the service may be absent
    double cancel_timeout = 0;  ///< behind the end, in which an answer still counts
    TimeLimit end;
  };

  /// `give_up`: on what it is abandoned.
  Reply call(const std::string& service, const std::string& md5, const Bytes& request,
             const Limits& limits, On give_up = On::Interrupt);

  /// Waits until somebody offers it; false: nobody does, or an interrupt came.
  bool isOffered(const std::string& service, Clock::time_point until);

  std::string resolved(const std::string& service) const { return node_.resolveName(service); }

  /// The same for a type that is known here; nothing: no answer. `kind`, if given, says why.
  template <typename Service>
  std::optional<typename Service::Response> call(const std::string& service,
                                                 const typename Service::Request& request,
                                                 double patience, Clock::time_point end,
                                                 Reply::Kind* kind = nullptr,
                                                 On give_up = On::Interrupt) {
    namespace serialization = ros::serialization;
    Bytes bytes(serialization::serializationLength(request));
    serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    serialization::serialize(out, request);
    Reply reply =
        call(service, ros::service_traits::md5sum<Service>(), bytes, {patience, 0, end}, give_up);
    if (kind != nullptr) *kind = reply.kind;
    if (reply.kind != Reply::Kind::Answered) return std::nullopt;
    typename Service::Response response;
    serialization::IStream in(reply.response.data(),
                              static_cast<std::uint32_t>(reply.response.size()));
    serialization::deserialize(in, response);
    return response;
  }

 private:
  struct Call;
  struct Shared;

  bool start(const std::shared_ptr<Call>& call);

  ros::NodeHandle node_;
  std::shared_ptr<Shared> shared_;  // outlives this object while a call does
  WaitPoint& wait_;
};

}  // namespace goal_alignment::any_message
