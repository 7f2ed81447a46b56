// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <chrono>

namespace fairing {

/// Seconds since it was made and since the last lap.
class Stopwatch {
 public:
  [[nodiscard]] double total() const { return seconds(Clock::now() - start_); }
  double lap() {
    const auto now = Clock::now();
    const double since = seconds(now - lap_);
    lap_ = now;
    return since;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }
  Clock::time_point start_ = Clock::now();
  Clock::time_point lap_ = start_;
};

}  // namespace fairing
