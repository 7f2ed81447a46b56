// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/base/parallel_for.h"

#include <gmock/gmock.h>

#include <chrono>
#include <mutex>
#include <set>

namespace fairing {
namespace {

constexpr int kOuter = 6, kInner = 20;

/// How many threads are in a place at once, at most.
class Crowd {
 public:
  void visit() {
    const int now = ++inside_;
    for (int seen = most_; now > seen && !most_.compare_exchange_weak(seen, now);) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // others have time to join
    --inside_;
  }
  [[nodiscard]] int most() const { return most_; }

 private:
  std::atomic<int> inside_{0}, most_{0};
};

TEST(ParallelFor, DoesEverythingOnceAlsoWithinALoop) {
  std::vector<std::vector<std::atomic<int>>> done(kOuter);
  for (auto& row : done) row = std::vector<std::atomic<int>>(kInner);
  parallelFor(3, kOuter, [&](int i) {
    inParallel(kInner, [&](std::size_t k) { ++done[std::size_t(i)][k]; });
  });
  for (const auto& row : done)
    for (const auto& times : row) EXPECT_EQ(times, 1);
}

TEST(ParallelFor, StartsNoMoreThreadsWithinALoopThanTheMachineHas) {
  Crowd crowd;
  inParallel(kOuter, [&](std::size_t) { inParallel(kInner, [&](std::size_t) { crowd.visit(); }); });
  EXPECT_LE(crowd.most(), threadsHere());
}

TEST(ParallelFor, StaysOnItsOwnThreadWhereThatHasNoMoreToItself) {
  const ThreadShare alone(1);
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallelFor(4, kInner, [&](int) {
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_THAT(seen, ::testing::ElementsAre(std::this_thread::get_id()));
}

TEST(ParallelFor, HandsItsShareDownAndGivesItBack) {
  const int before = threadsHere();
  {
    const ThreadShare four(4);
    EXPECT_EQ(threadsHere(), 4);
    parallelFor(2, 2, [](int) { EXPECT_EQ(threadsHere(), 2); });
    parallelFor(4, 1, [](int) { EXPECT_EQ(threadsHere(), 4); });
    EXPECT_EQ(threadsHere(), 4);
    {
      const ThreadShare one(0);
      EXPECT_EQ(threadsHere(), 1);
    }
    EXPECT_EQ(threadsHere(), 4);
  }
  EXPECT_EQ(ThreadShare::own(), 0);
  EXPECT_EQ(threadsHere(), before);
}

TEST(ParallelFor, TakesAsManyThreadsAsAskedForWhereNoOneElseIsAtWork) {
  Crowd crowd;
  parallelFor(3, kInner, [&](int) { crowd.visit(); });
  EXPECT_EQ(crowd.most(), 3);
}

}  // namespace
}  // namespace fairing
