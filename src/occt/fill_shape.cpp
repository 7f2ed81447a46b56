// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/fill_shape.h"

#include "occt/inner_constraints.h"
#include "occt/make_faces.h"
#include "occt/read_boundary.h"
#include "occt/support_notes.h"

namespace fairing::occt {

ShapeFill preview(const ShapeFill& before, FillResult fill) {
  addSingularSupports(before.loop, fill.report);
  return ShapeFill{{}, std::move(fill), before.loop, before.live};
}

Result<TopoDS_Shape> shapeOf(const ShapeFill& fill) {
  if (fill.shape.IsNull()) return makeFaces(fill.fill);
  return fill.shape;
}

Result<ShapeFill> fillShape(const ShapeIndex& index,
                            const Picks& picks,
                            const FillOptions& options,
                            ResultMode mode,
                            Progress* progress) {
  if (const auto error = validate(options)) return fail(*error);
  auto loop = readBoundary(index, picks);
  if (!loop) return fail(loop.error());
  if (const auto error = checkThrough(*loop, options.through)) return fail(*error);
  auto fill = fillHole(*loop, options, progress);
  if (!fill) return fail(fill.error());
  addSingularSupports(*loop, fill->report);
  const auto faces = makeFaces(*fill);
  if (!faces) return fail(faces.error());
  const auto shape =
      joinResult(index, picks.faces, {{*faces, *loop, fill->report.largestGap}}, mode);
  if (!shape) return fail(shape.error());
  auto live = std::make_shared<LiveFill>(*loop, options, *fill);
  return ShapeFill{*shape, std::move(*fill), std::move(*loop), std::move(live)};
}

}  // namespace fairing::occt
