// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/boundary/chain_walk.h"

#include <algorithm>
#include <cmath>

namespace fairing::boundary {
namespace {

// A place closer to a joint than this share of the chain's length is at it.
constexpr double kAtJoint = 1e-9;

}  // namespace

ChainWalk::ChainWalk(const std::vector<BoundarySide>& sides,
                     std::size_t first,
                     std::size_t count,
                     ChainEnds ends)
    : first_(first), ends_(ends) {
  for (std::size_t k = first; k < first + count; ++k) {
    curves_.push_back(sides[k].ribbon.curve);
    arcs_.emplace_back(sides[k].ribbon, 0.0, 1.0);
    length_ += arcs_.back().length();
  }
}

LoopPlace ChainWalk::placeAt(double share) const {
  const bool closed = ends_ == ChainEnds::Closed;
  double rest = (closed ? share - std::floor(share) : std::clamp(share, 0.0, 1.0)) * length_;
  std::size_t k = 0;
  while (k < arcs_.size() && rest >= arcs_[k].length() - kAtJoint * length_)
    rest -= arcs_[k++].length();
  if (k == arcs_.size()) return closed ? LoopPlace{first_, 0.0} : LoopPlace{first_ + k - 1, 1.0};
  if (rest <= kAtJoint * length_) return {first_ + k, 0.0};
  return {first_ + k, arcs_[k].parameterAt(rest)};
}

Eigen::Vector3d ChainWalk::at(double share) const {
  const LoopPlace place = placeAt(share);
  return curves_[place.side - first_](place.t).point;
}

double ChainWalk::startOf(std::size_t side) const {
  double behind = 0.0;
  for (std::size_t k = 0; k < side - first_; ++k) behind += arcs_[k].length();
  return behind / length_;
}

double ChainWalk::shareAt(LoopPlace place) const {
  return startOf(place.side) + arcs_[place.side - first_].lengthUpTo(place.t) / length_;
}

}  // namespace fairing::boundary
