// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/finish_on_interrupt.h"

#include <atomic>
#include <csignal>

namespace fairing::cli {
namespace {

// Of the solve that runs; the handler may do no more than set its flag.
std::atomic<Progress*> running{nullptr};

void finish(int) {
  if (Progress* progress = running.load()) progress->requestFinish();
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

FinishOnInterrupt::FinishOnInterrupt() {
  running.store(&progress_);
  std::signal(SIGINT, finish);
}

FinishOnInterrupt::~FinishOnInterrupt() {
  std::signal(SIGINT, SIG_DFL);
  running.store(nullptr);
}

}  // namespace fairing::cli
