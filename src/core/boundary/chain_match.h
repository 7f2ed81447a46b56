// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

#include "core/boundary/cut_loop.h"

namespace fairing::boundary {

/// Which points of two chains belong together.
enum class MatchKind {
  Auto,    ///< corner to corner where both chains have as many, else by length
  Length,  ///< equal shares of the chains' lengths
  Corners  ///< the k-th corner of one to the k-th of the other
};

/// Two joints of edges, one of either chain, that belong together.
struct JointPair {
  LoopPlace first, second;
  int firstVertex = 0, secondVertex = 0;  ///< FreeCAD's VertexN, for messages
};

struct ChainMatch {
  MatchKind kind = MatchKind::Auto;
  /// How far closed chains are turned from where they are least twisted: by a share of the second
  /// chain's length in its direction, -0.5 to 0.5. Where corners are matched, to the nearest one.
  double alignment = 0.0;
  std::vector<JointPair> pairs = {};  ///< hold whatever the kind; it matches what lies between
};

}  // namespace fairing::boundary
