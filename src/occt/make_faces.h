// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>

#include "core/base/result.h"
#include "core/fill/fill_hole.h"

namespace fairing::occt {

/// One face a patch, bounded by the patch's own border curves: edges lie on their surfaces exactly,
/// and tolerances are the kernel's smallest; or, where the patch is trimmed, by its trim
/// (trimmed_face.h). A single patch gives a face; several give a shell of
/// faces that share their common edges. Faces are oriented like the supports. Fails with
/// ResultInvalid where a face does not pass the kernel's check.
[[nodiscard]] Result<TopoDS_Shape> makeFaces(const FillResult& fill);

}  // namespace fairing::occt
