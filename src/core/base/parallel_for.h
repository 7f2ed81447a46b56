// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace fairing {

/// As many threads as the machine runs at once.
[[nodiscard]] inline int threadsOfMachine() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Calls work(i) for i = 0 ... count - 1, each once, on so many threads, this one among them.
/// Returns when all is done; `work` does not throw.
template <class Work>
void parallelFor(int threads, int count, const Work& work) {
  std::atomic<int> next{0};
  const auto takeWhatIsLeft = [&] {
    for (int i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> crew;
  for (int t = 1; t < std::min(threads, count); ++t) crew.emplace_back(takeWhatIsLeft);
  takeWhatIsLeft();
}

/// The same for every place of a container, on as many threads as the machine runs at once.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
  parallelFor(threadsOfMachine(), static_cast<int>(count), [&](int k) {
    work(static_cast<std::size_t>(k));
  });
}

}  // namespace fairing
