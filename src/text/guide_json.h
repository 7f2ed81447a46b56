// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/result.h"
#include "core/energy/guidance.h"

namespace fairing::text {

/// Handles, curves, a field, or several of them:
///   {"normals": [{"point": [x, y, z], "normal": [x, y, z], "weight": w, "radius": r}, ...],
///    "curves": [{"points": [[x, y, z], ...], "normals": [[x, y, z], ...], "weight": w, "radius":
///    r},
///               ...],
///    "field": {"n": 8, "m": 8, "normals": [[x, y, z], ...], "weights": [w, ...]}}
/// A list alone, if not empty, is the list of handles. weight may be left out (1), radius is in mm.
/// A curve has a normal for each of its points, or one for all.
/// The field has (n + 1)(m + 1) normals over the patch's parameters, those at (i / n, j / m) at
/// place i (m + 1) + j, weights 1 unless given. With "degree": [p, q] in place of n and m it is a
/// continuous one: its normals are control points, on "knots": [[...], [...]] in full or, without
/// them, of one Bezier patch; their lengths count. "corners": [[x, y, z], ...] says where the
/// field's (0, 0), (1, 0) and (0, 1) lie. Other normals need not be of unit length. Fails with
/// GuideInvalid; the sentence starts with `source`.
[[nodiscard]] Result<energy::Guidance> guidanceFrom(const nlohmann::json& guide,
                                                    const std::string& source);

}  // namespace fairing::text
