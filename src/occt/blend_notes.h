// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "core/boundary/side_chain.h"
#include "core/span/fill_result.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// Adds to a blend's report what is wrong with it as a surface in its place: where it folds, cuts
/// through itself or through the faces it joins, and where these overlap. By triangles whose
/// distance from the surfaces is below 0.2 % of the blend's diagonal; what happens within 1 % of
/// the joined edges is not seen.
void addBlendNotes(const ShapeIndex& index, const boundary::ChainPair& pair, FillResult& blend);

}  // namespace fairing::occt
