// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "core/height_field/trim.h"

namespace fairing::occt {

/// The part of a surface to the left of a closed trim: one edge a curve, carried by the trim's
/// curve in space and its image in the parameters. An edge's tolerance is the largest distance
/// between the two that is found, a vertex's the largest distance of what meets there; neither is
/// below the kernel's smallest.
[[nodiscard]] TopoDS_Face trimmedFace(const Handle(Geom_Surface) & surface, const Trim& trim);

}  // namespace fairing::occt
