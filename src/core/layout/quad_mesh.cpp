// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/quad_mesh.h"

#include <map>
#include <utility>

namespace fairing::layout {
namespace {

// Directions of quads joined into classes, with the parity of each towards its class.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count), flipped_(count, false) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }
  [[nodiscard]] std::pair<std::size_t, bool> root(std::size_t i) const {
    bool flipped = false;
    while (parent_[i] != i) {
      flipped = flipped != flipped_[i];
      i = parent_[i];
    }
    return {i, flipped};
  }
  void join(std::size_t a, std::size_t b, bool opposite) {
    const auto [ra, fa] = root(a);
    const auto [rb, fb] = root(b);
    if (ra == rb) return;
    const auto low = std::min(ra, rb), high = std::max(ra, rb);
    parent_[high] = low;
    flipped_[high] = (fa != fb) != opposite;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<bool> flipped_;
};

std::size_t slot(const QuadEdge& e) {
  return 2 * static_cast<std::size_t>(e.quad) + directionOf(e.edge);
}

}  // namespace

Eigen::Vector2d QuadMesh::way(int from, int to) const {
  if (!vertices.empty())
    return vertices[static_cast<std::size_t>(to)] - vertices[static_cast<std::size_t>(from)];
  return ways.at({from, to});
}

std::vector<QuadSeam> QuadMesh::seams() const {
  std::map<std::pair<int, int>, QuadEdge> waiting;
  std::vector<QuadSeam> result;
  for (std::size_t q = 0; q < quads.size(); ++q)
    for (std::size_t k = 0; k < 4; ++k) {
      if (quads[q].sides[k] >= 0) continue;
      const int from = quads[q].vertices[k], to = quads[q].vertices[(k + 1) % 4];
      const QuadEdge own{static_cast<int>(q), kPatchEdges[k]};
      const auto other = waiting.find({to, from});
      if (other == waiting.end()) {
        waiting[{from, to}] = own;
        continue;
      }
      result.push_back({other->second, own, to, from});
      waiting.erase(other);
    }
  return result;
}

Strips stripsOf(const QuadMesh& mesh) {
  Classes classes(2 * mesh.quads.size());
  for (const QuadSeam& seam : mesh.seams()) {
    // Along the first edge the second runs backwards.
    const bool opposite = falls(seam.first.edge) == falls(seam.second.edge);
    classes.join(slot(seam.first), slot(seam.second), opposite);
  }
  Strips strips;
  std::map<std::size_t, int> number;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    std::array<StripUse, 2> uses;
    for (std::size_t d = 0; d < 2; ++d) {
      const auto [root, flipped] = classes.root(2 * q + d);
      const auto [entry, isNew] = number.emplace(root, strips.count);
      if (isNew) ++strips.count;
      uses[d] = {entry->second, flipped};
    }
    strips.uses.push_back(uses);
  }
  return strips;
}

}  // namespace fairing::layout
