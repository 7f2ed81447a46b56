// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <memory>

#include "core/fill/fill_hole.h"
#include "core/fill/live_fill.h"
#include "occt/join.h"
#include "occt/picks.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// A filled hole of a shape.
struct ShapeFill {
  TopoDS_Shape shape;  ///< what was asked for: faces, shell or base; null in a preview
  FillResult fill;
  boundary::BoundaryLoop loop;
  std::shared_ptr<LiveFill> live = nullptr;  ///< what guiding() moves
};

/// Another fill of the same hole, with notes on its supports, as it is while something is dragged:
/// faces would take longer than the surface.
[[nodiscard]] ShapeFill preview(const ShapeFill& before, FillResult fill);

/// What was asked for; of a preview its faces alone, made now. Fails as makeFaces() does.
[[nodiscard]] Result<TopoDS_Shape> shapeOf(const ShapeFill& fill);

/// The whole way: loop, patches, faces, result. Fails with the codes of readBoundary(), fillHole()
/// and joinResult().
[[nodiscard]] Result<ShapeFill> fillShape(const ShapeIndex& index,
                                          const Picks& picks,
                                          const FillOptions& options,
                                          ResultMode mode,
                                          Progress* progress = nullptr);

}  // namespace fairing::occt
