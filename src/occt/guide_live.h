// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "occt/blend_shape.h"
#include "occt/fill_shape.h"

namespace fairing::occt {

/// The same fill under other guidance, as a preview: one numeric factorisation, so that it follows
/// a slider or a handle. Unless `lookUp` asks for it, what guides stays where it was looked up
/// before. By one thread at a time. Fails as LiveFill::under() does.
[[nodiscard]] Result<ShapeFill> guiding(const ShapeFill& fill,
                                        const energy::Guidance& guidance,
                                        bool lookUp);
[[nodiscard]] Result<ShapeBlend> guiding(const ShapeBlend& blend,
                                         const energy::Guidance& guidance,
                                         bool lookUp);

}  // namespace fairing::occt
