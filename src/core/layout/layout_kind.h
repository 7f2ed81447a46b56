// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing {

enum class LayoutKind {
  Auto,      ///< chosen from the loop
  Quad,      ///< one patch between four sides
  Star,      ///< a patch a corner round one inner vertex, three corners or more
  OGrid,     ///< a ring of four patches round an inner one: round holes, one or two corners
  Strip,     ///< one patch between two chains: blends; not for holes
  Junction,  ///< stars round three or more closed chains, front and back: blends; not for holes
  Trimmed,   ///< one surface over a plane, trimmed by the loop
};

}  // namespace fairing
