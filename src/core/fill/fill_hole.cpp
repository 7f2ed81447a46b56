// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/fill/fill_hole.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "core/fill/fill_trimmed.h"
#include "core/layout/layouts.h"
#include "core/span/refine.h"
#include "core/span/span_plan.h"

// The pipeline (docs/ARCHITECTURE.md):
//
//   BoundaryLoop -> kinds that suit it -> LayoutPlan -> spanPlan -> within tolerance? -> done
//                          ^                                             |
//                          +------------- the next kind -----------------+
//
//   spanPlan:  LayoutPlan -> fair shape on few knots -+
//                  |                                  |
//                  +-> PatchLayout -> constraints, energy -> solver -> patches -> report -> done
//                          ^                                                         |
//                          +------------------ finer knots where it is over ---------+

namespace fairing {
namespace {

// The whole way with one kind of layout.
Result<FillResult> fillWith(LayoutKind kind,
                            const boundary::BoundaryLoop& loop,
                            const FillOptions& options,
                            Progress* progress) {
  if (kind == LayoutKind::Trimmed) return fillTrimmed(loop, options, progress);
  auto made = makeSpan(loop, options, [&](const boundary::BoundaryLoop& target) {
    return layout::planLayout(target, kind);
  });
  if (!made) return fail(made.error());
  const auto span = std::make_shared<const Span>(std::move(*made));
  auto result = spanPlan(*span, options, progress);
  if (result) result->span = span;
  return result;
}

void noteTinySides(const boundary::BoundaryLoop& loop, analysis::FillReport& report) {
  for (const boundary::BoundarySide& side : loop.sides)
    if (layout::isTiny(side, loop.diagonal))
      report.notes.push_back(
          {analysis::NoteCode::EdgeAbsorbed, side.edge, side.ribbon.curve(0.5).point, side.length});
}

}  // namespace

Result<FillResult> fillHole(const boundary::BoundaryLoop& loop,
                            const FillOptions& options,
                            Progress* progress) {
  if (const auto wrong = validate(options)) return fail(*wrong);
  if (const auto tooMany = layout::tooManySides(loop)) return fail(*tooMany);
  if (options.layout != LayoutKind::Auto) return fillWith(options.layout, loop, options, progress);
  std::optional<Result<FillResult>> best;
  for (const LayoutKind kind : layout::suitableKinds(loop)) {
    auto tried = fillWith(kind, loop, options, progress);
    if (!tried && tried.error().code == ErrorCode::Cancelled) return tried;
    if (best && *best && tried)
      best = better(std::move(**best), std::move(*tried));
    else if (!best || (!*best && tried))
      best = std::move(tried);
    if (*best && (*best)->report.withinTolerance) break;
  }
  if (*best) noteTinySides(loop, (*best)->report);
  return std::move(*best);
}

}  // namespace fairing
