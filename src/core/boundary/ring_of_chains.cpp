// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/ring_of_chains.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace fairing::boundary {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostChains = 8;  // all orders are tried

struct Ends {
  Vector3d start, end;
};

// Chains in a ring: which one comes when, and whether it is turned round.
struct Order {
  std::vector<std::size_t> chains;
  unsigned turned = 0;  // bit k: the chain that comes k-th

  [[nodiscard]] bool isTurned(std::size_t k) const { return (turned >> k) % 2 == 1; }
};

double waysBetween(const std::vector<Ends>& ends, const Order& order) {
  const auto at = [&](std::size_t k) {
    const Ends& chain = ends[order.chains[k]];
    return order.isTurned(k) ? Ends{chain.end, chain.start} : chain;
  };
  const std::size_t n = ends.size();
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) sum += (at((k + 1) % n).start - at(k).end).norm();
  return sum;
}

Order shortest(const std::vector<Ends>& ends) {
  Order order, best;
  order.chains.resize(ends.size());
  std::iota(order.chains.begin(), order.chains.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    for (order.turned = 0; order.turned < 1U << ends.size(); order.turned += 2)
      if (const double ways = waysBetween(ends, order); ways < least) {
        least = ways;
        best = order;
      }
  } while (std::next_permutation(order.chains.begin() + 1, order.chains.end()));
  return best;
}

bool touches(const SideChain& before, const SideChain& after, double diagonal) {
  const Corner corner = cornerBetween(before.sides.back(), after.sides.front());
  return !checkMeeting(before.sides.back(), corner, diagonal);
}

// Lets the chains that the first one touches go before it, so that a gap is before all of them.
std::optional<Error> beginAtGap(std::vector<SideChain>& ring, double diagonal) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (!touches(ring.back(), ring.front(), diagonal)) return std::nullopt;
    std::rotate(ring.begin(), ring.end() - 1, ring.end());
  }
  return Error{.code = ErrorCode::RingWithoutGap, .edge = ring.front().sides.front().edge};
}

}  // namespace

Result<BoundaryLoop> ringOfChains(const std::vector<SideChain>& chains) {
  if (chains.size() > kMostChains)
    return fail({.code = ErrorCode::TooManySides, .value = static_cast<double>(chains.size())});
  std::vector<Ends> ends;
  std::vector<BoundarySide> all;
  for (const SideChain& chain : chains) {
    if (chain.closed)
      return fail({.code = ErrorCode::ChainsUnlike, .edge = chain.sides.front().edge});
    ends.push_back(
        {chain.sides.front().ribbon.curve(0.0).point, chain.sides.back().ribbon.curve(1.0).point});
    all.insert(all.end(), chain.sides.begin(), chain.sides.end());
  }
  const auto measured = measureSides(std::move(all));
  if (!measured) return fail(measured.error());
  const Order order = shortest(ends);
  std::vector<SideChain> ring;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    const SideChain& chain = chains[order.chains[k]];
    ring.push_back(order.isTurned(k) ? reversed(chain) : chain);
  }
  if (const auto closed = beginAtGap(ring, measured->diagonal)) return fail(*closed);
  std::vector<BoundarySide> sides;
  std::vector<std::size_t> further;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (k > 0 && !touches(ring[k - 1], ring[k], measured->diagonal))
      further.push_back(sides.size());
    sides.insert(sides.end(), ring[k].sides.begin(), ring[k].sides.end());
  }
  return makeOpenChains(std::move(sides), std::move(further));
}

}  // namespace fairing::boundary
