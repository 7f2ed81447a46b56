// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace fairing::boundary {

/// The direction within a side's tangent planes in which a patch leaves it: that of its cross
/// tangents.
enum class Departure {
  Free,           ///< as the energy likes it best
  Perpendicular,  ///< perpendicular to the edge
  Iso,            ///< along those iso-curves of the face beside it that cross the edge
};

/// Which way a patch leaves a side in its tangent planes.
enum class Leaving {
  Onwards,    ///< away from the face beside it
  Backwards,  ///< over that face: its border is then taken for the other side's
};

}  // namespace fairing::boundary
