// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/fill_all.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/parallel_for.h"
#include "occt/find_holes.h"
#include "occt/guarded.h"

namespace fairing::occt {
namespace {

constexpr std::chrono::milliseconds kWatch{10};  // between looks at progress and abort

/// Hands out the holes to threads and keeps what they make in the order of the holes.
class Crew {
 public:
  Crew(const ShapeIndex& index, const std::vector<Picks>& holes, const FillOptions& options)
      : index_(index), holes_(holes), options_(options), progress_(holes.size()) {
    made_.resize(holes.size());
  }

  std::vector<HoleFill> work(Progress* shared, int threads) {
    if (shared != nullptr) report(*shared);  // an abort may have come before the work
    {
      std::vector<std::jthread> crew;
      const int share = threadsHere() / std::max(1, threads);
      for (int i = 0; i < threads; ++i)
        crew.emplace_back([this, share] {
          const ThreadShare loops(share);
          fillWhatIsLeft();
        });
      watch(shared);
    }
    std::vector<HoleFill> fills;
    for (std::size_t i = 0; i < holes_.size(); ++i) {
      fills.push_back({holes_[i].edges, holes_[i].faces, std::move(*made_[i])});
    }
    return fills;
  }

 private:
  void fillWhatIsLeft() {
    for (std::size_t i = next_++; i < holes_.size(); i = next_++) {
      made_[i] = guarded([&] {
        return fillShape(index_, holes_[i], options_, ResultMode::Patches, &progress_[i]);
      });
      progress_[i].setFraction(1.0);
      const std::lock_guard lock(mutex_);
      ++done_;
      changed_.notify_one();
    }
  }

  /// Passes progress up and an abort down until all holes are done.
  void watch(Progress* shared) {
    std::unique_lock lock(mutex_);
    while (done_ < holes_.size()) {
      changed_.wait_for(lock, kWatch);
      if (shared != nullptr) report(*shared);
    }
    if (shared != nullptr) shared->setFraction(1.0);
  }

  void report(Progress& shared) {
    double sum = 0.0;
    for (Progress& one : progress_) {
      sum += one.fraction();
      if (shared.isAbortRequested()) one.requestAbort();
      if (shared.isFinishRequested()) one.requestFinish();
    }
    shared.setFraction(sum / double(holes_.size()));
  }

  const ShapeIndex& index_;
  const std::vector<Picks>& holes_;
  const FillOptions& options_;
  std::vector<Progress> progress_;  // one a hole
  std::vector<std::optional<Result<ShapeFill>>> made_;
  std::atomic<std::size_t> next_{0};
  std::size_t done_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
};

JoinPart partOf(const ShapeFill& fill) {
  return {fill.shape, fill.loop, fill.fill.report.largestGap};
}

/// A hole that cannot be sewn by itself fails with the reason.
void refuseUnsewable(const ShapeIndex& index, std::vector<HoleFill>& holes) {
  for (HoleFill& hole : holes) {
    if (!hole.fill) continue;
    const auto alone = joinResult(index, hole.replaced, {partOf(*hole.fill)}, ResultMode::Base);
    if (!alone) hole.fill = fail(alone.error());
  }
}

Result<TopoDS_Shape> join(const ShapeIndex& index,
                          const std::vector<HoleFill>& holes,
                          ResultMode mode) {
  std::vector<JoinPart> parts;
  std::vector<int> replaced;
  for (const HoleFill& hole : holes) {
    if (!hole.fill) continue;
    parts.push_back(partOf(*hole.fill));
    replaced.insert(replaced.end(), hole.replaced.begin(), hole.replaced.end());
  }
  if (parts.empty()) return fail(holes.front().fill.error());
  return joinResult(index, replaced, parts, mode);
}

/// What is wished for the edges of a hole; taken out of what is left.
Picks takeWishes(const Hole& hole, HoleChoice& left) {
  Picks picks{.edges = hole.edges, .continuity = left.continuity};
  for (int edge : hole.edges) {
    if (auto wish = left.edgeContinuity.extract(edge)) picks.edgeContinuity.insert(std::move(wish));
    if (auto direction = left.directions.extract(edge))
      picks.directions.insert(std::move(direction));
  }
  return picks;
}

bool isSkipped(const Hole& hole, const std::set<int>& skipped) {
  return std::any_of(
      hole.edges.begin(), hole.edges.end(), [&](int edge) { return skipped.contains(edge); });
}

/// An edge that something is wished for, 0 for none.
int firstWish(const HoleChoice& choice) {
  if (!choice.edgeContinuity.empty()) return choice.edgeContinuity.begin()->first;
  return choice.directions.empty() ? 0 : choice.directions.begin()->first;
}

Error strayWish(const ShapeIndex& index, int edge) {
  if (index.hasEdge(edge)) return {.code = ErrorCode::EdgeNotInLoop, .edge = edge};
  return {.code = ErrorCode::EdgeOutOfRange, .edge = edge, .value = double(index.edgeCount())};
}

bool isCancelled(const std::vector<HoleFill>& holes) {
  return std::any_of(holes.begin(), holes.end(), [](const HoleFill& hole) {
    return !hole.fill && hole.fill.error().code == ErrorCode::Cancelled;
  });
}

}  // namespace

bool AllFilled::withinTolerance() const {
  return std::all_of(holes.begin(), holes.end(), [](const HoleFill& hole) {
    return hole.fill && hole.fill->fill.report.withinTolerance;
  });
}

Result<std::vector<Picks>> chooseHoles(const ShapeIndex& index, const HoleChoice& choice) {
  return guarded([&]() -> Result<std::vector<Picks>> {
    if (index.edgeCount() == 0) return fail({.code = ErrorCode::ShapeEmpty});
    HoleChoice left = choice;
    const std::vector<Hole> found = findHoles(index);
    std::vector<Picks> chosen;
    for (const Hole& hole : found) {
      if (hole.isOuterBorder && !choice.outerBorders) continue;
      Picks picks = takeWishes(hole, left);
      if (!isSkipped(hole, choice.skipped)) chosen.push_back(std::move(picks));
    }
    if (const int stray = firstWish(left); stray != 0) return fail(strayWish(index, stray));
    if (chosen.empty())
      return fail({.code = found.empty() ? ErrorCode::NothingPicked : ErrorCode::NoHole});
    return chosen;
  });
}

std::vector<HoleFill> fillHoles(const ShapeIndex& index,
                                const std::vector<Picks>& holes,
                                const FillOptions& options,
                                Progress* progress,
                                int threads) {
  const int wanted = threads > 0 ? threads : threadsHere();
  return Crew(index, holes, options).work(progress, std::min(wanted, int(holes.size())));
}

Result<AllFilled> joinHoles(const ShapeIndex& index, std::vector<HoleFill> holes, ResultMode mode) {
  auto shape = join(index, holes, mode);
  if (!shape && mode == ResultMode::Base) {
    refuseUnsewable(index, holes);
    shape = join(index, holes, mode);
  }
  if (!shape) return fail(shape.error());
  return AllFilled{std::move(holes), *shape};
}

Result<AllFilled> fillAll(const ShapeIndex& index,
                          const HoleChoice& choice,
                          const FillOptions& options,
                          ResultMode mode,
                          Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  const auto chosen = chooseHoles(index, choice);
  if (!chosen) return fail(chosen.error());
  auto holes = fillHoles(index, *chosen, options, progress);
  if (isCancelled(holes)) return fail({.code = ErrorCode::Cancelled});
  return joinHoles(index, std::move(holes), mode);
}

}  // namespace fairing::occt
