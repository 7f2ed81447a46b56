// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

#include "core/fill/fill_hole.h"

namespace fairing::text {

/// One sentence in words and numbers: how well all edges are met, or what is missed most - an edge,
/// a seam between patches, an inner constraint -, by how much, where and why.
[[nodiscard]] std::string verdict(const analysis::FillReport& report);

/// One line an edge under a head line, in columns; then, where there are any, one a seam, one an
/// inner constraint, one about guidance, and one a note. Ends with a line break.
[[nodiscard]] std::string table(const analysis::FillReport& report);

/// How the hole is spanned: "Layout star: 5 patches, 320 control points."
[[nodiscard]] std::string composition(const FillResult& fill);

/// One hole of several: what it was filled with, or why it was not.
struct HoleLine {
  std::vector<int> edges;
  const FillResult* fill = nullptr;
  const Error* error = nullptr;  ///< read where `fill` is null
};

/// One line a hole under a head line: number, first edge, sides, layout, worst gap and angle,
/// verdict. Ends with a line break.
[[nodiscard]] std::string table(const std::vector<HoleLine>& holes);

}  // namespace fairing::text
