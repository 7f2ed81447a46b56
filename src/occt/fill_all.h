// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <set>
#include <vector>

#include "occt/fill_shape.h"

namespace fairing::occt {

/// Which holes of a shape are to be filled, and how they are to meet their neighbours.
struct HoleChoice {
  bool outerBorders = false;   ///< the rims of open sheets, too
  std::set<int> skipped = {};  ///< holes that have one of these edges are left out
  Continuity continuity = Continuity::G1;
  // By edge number, whichever hole has the edge.
  std::map<int, Continuity> edgeContinuity = {};
  std::map<int, EdgeDirection> directions = {};
};

/// What became of one hole: its new faces, or why there are none.
struct HoleFill {
  std::vector<int> edges;     ///< FreeCAD's numbers, in order, or those picked
  std::vector<int> replaced;  ///< faces that are to go
  Result<ShapeFill> fill;
};

/// A shape's holes, filled.
struct AllFilled {
  std::vector<HoleFill> holes;  ///< by ascending lowest edge
  TopoDS_Shape shape;           ///< what was asked for, of all holes that could be filled
  [[nodiscard]] bool withinTolerance() const;  ///< every hole is
};

/// The holes of a shape that a choice means. Fails with ShapeEmpty, NoHole where there are only
/// outer borders, NothingPicked where there is no loop of free edges, EdgeOutOfRange or
/// EdgeNotInLoop for wishes that no hole has.
[[nodiscard]] Result<std::vector<Picks>> chooseHoles(const ShapeIndex& index,
                                                     const HoleChoice& choice);

/// Fills holes side by side on as many threads as the machine has, or `threads` of them; what a
/// hole itself does in parallel shares these. The result does not depend on how many. A hole that
/// fails, in whatever way, leaves the others alone. `progress` counts all holes; aborting it stops
/// them all.
[[nodiscard]] std::vector<HoleFill> fillHoles(const ShapeIndex& index,
                                              const std::vector<Picks>& holes,
                                              const FillOptions& options,
                                              Progress* progress = nullptr,
                                              int threads = 0);

/// Puts the filled holes together. A hole that cannot be sewn into the base becomes a failure of
/// its own and stays open. Fails with the first hole's error where none is filled, and with the
/// codes of joinResult().
[[nodiscard]] Result<AllFilled> joinHoles(const ShapeIndex& index,
                                          std::vector<HoleFill> holes,
                                          ResultMode mode);

/// The whole way: chooseHoles(), fillHoles(), joinHoles(). Fails with Cancelled, too.
[[nodiscard]] Result<AllFilled> fillAll(const ShapeIndex& index,
                                        const HoleChoice& choice,
                                        const FillOptions& options,
                                        ResultMode mode,
                                        Progress* progress = nullptr);

}  // namespace fairing::occt
