// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <utility>
#include <vector>

namespace fairing {

/// While it lives, the loops of this thread run on so many threads at most. Whoever works side by
/// side with others has one: loops within loops would start threads upon threads.
class ThreadShare {
 public:
  explicit ThreadShare(int threads) : before_(std::exchange(share_, std::max(1, threads))) {}
  ~ThreadShare() { share_ = before_; }
  ThreadShare(const ThreadShare&) = delete;
  ThreadShare& operator=(const ThreadShare&) = delete;

  /// Of this thread; 0 = no one else is at work.
  [[nodiscard]] static int own() { return share_; }

 private:
  inline static thread_local int share_ = 0;
  int before_;
};

/// As many threads as a loop of this thread may run on: those the machine runs at once, or this
/// thread's share of them.
[[nodiscard]] inline int threadsHere() {
  if (const int share = ThreadShare::own(); share > 0) return share;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Calls work(i) for i = 0 ... count - 1, each once, on so many threads, this one among them; on
/// fewer where this thread has no more to itself. Loops within `work` share what this one has.
/// Returns when all is done; `work` does not throw.
template <class Work>
void parallelFor(int threads, int count, const Work& work) {
  const int here = threadsHere();
  const int most = ThreadShare::own() > 0 ? std::min(threads, here) : threads;
  const int crewSize = std::max(1, std::min(most, count));
  std::atomic<int> next{0};
  const auto takeWhatIsLeft = [&] {
    const ThreadShare share(here / crewSize);
    for (int i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> crew;
  for (int t = 1; t < crewSize; ++t) crew.emplace_back(takeWhatIsLeft);
  takeWhatIsLeft();
}

/// The same for every place of a container, on as many threads as there may be here.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
  parallelFor(
      threadsHere(), static_cast<int>(count), [&](int k) { work(static_cast<std::size_t>(k)); });
}

}  // namespace fairing
