// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <atomic>

namespace fairing {

/// Shared between the thread that works and the one that watches. Both sides may call any member at
/// any time.
class Progress {
 public:
  void requestAbort() noexcept { abort_.store(true); }
  [[nodiscard]] bool isAbortRequested() const noexcept { return abort_.load(); }
  /// Asks for the best that can be had at once, in place of an abort: no more steps towards the
  /// least energy are taken, and what they have reached is finished and returned, marked as such.
  void requestFinish() noexcept { finish_.store(true); }
  [[nodiscard]] bool isFinishRequested() const noexcept { return finish_.load(); }
  /// Share of the work done, 0 to 1.
  void setFraction(double fraction) noexcept { fraction_.store(fraction); }
  [[nodiscard]] double fraction() const noexcept { return fraction_.load(); }

 private:
  std::atomic<bool> abort_{false}, finish_{false};
  std::atomic<double> fraction_{0.0};
};

}  // namespace fairing
