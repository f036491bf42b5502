// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace goal_alignment::cli {

namespace {

// A signal handler reaches nothing but globals; both cancels are one store to an atomic.
std::atomic<session::Session*> g_session{nullptr};
std::atomic<CancelToken*> g_token{nullptr};

void onSignal(int signal) {
  if (session::Session* session = g_session.load()) session->cancel();
  if (CancelToken* token = g_token.load()) token->cancel();
  std::signal(signal, SIG_DFL);
}

void install(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  // Without SA_RESTART a blocked read of an answer returns at once.
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard(session::Session& session) {
  g_session = &session;
  install(onSignal);
}

InterruptGuard::InterruptGuard(CancelToken& token) {
  g_token = &token;
  install(onSignal);
}

InterruptGuard::~InterruptGuard() {
  install(SIG_DFL);
  g_session = nullptr;
  g_token = nullptr;
}

}  // namespace goal_alignment::cli
