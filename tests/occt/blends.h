// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <gp_Ax3.hxx>
#include <vector>

#include "occt/blend_shape.h"

/// Blends for the tests, and what these ask of them.
namespace fairing::testing {

using Blended = Result<occt::ShapeBlend>;

[[nodiscard]] Blended tryBlend(const TopoDS_Shape& shape,
                               const occt::BlendPicks& picks,
                               occt::ResultMode mode = occt::ResultMode::Patches,
                               const BlendOptions& options = {});
/// A blend that is expected to succeed.
[[nodiscard]] occt::ShapeFill blended(const TopoDS_Shape& shape,
                                      const occt::BlendPicks& picks,
                                      occt::ResultMode mode = occt::ResultMode::Patches,
                                      const BlendOptions& options = {});
/// The code of a blend that is expected to fail.
[[nodiscard]] ErrorCode refusal(const TopoDS_Shape& shape,
                                const occt::BlendPicks& picks,
                                const BlendOptions& options = {});

/// What a blend that is expected to fail says.
[[nodiscard]] Error errorOf(const TopoDS_Shape& shape,
                            const occt::BlendPicks& picks,
                            const BlendOptions& options = {});

/// Within tolerance, seams included, with gaps below 1e-6 of the diagonal, and valid faces.
void expectWithin(const occt::ShapeFill& blend);

/// The edges nearest to points of either side, and to those of the ends.
[[nodiscard]] occt::BlendPicks picksNear(const TopoDS_Shape& shape,
                                         const std::vector<Eigen::Vector3d>& from,
                                         const std::vector<Eigen::Vector3d>& to,
                                         const std::vector<Eigen::Vector3d>& ends = {});
/// The edges nearest to two points, a side each.
[[nodiscard]] occt::BlendPicks between(const TopoDS_Shape& shape,
                                       const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& to,
                                       Continuity continuity = Continuity::G1);

/// An upright frame at a height.
[[nodiscard]] gp_Ax3 upright(double z = 0.0);
/// A pipe round the axis of a frame, from one height over it to another.
[[nodiscard]] TopoDS_Shape pipe(const gp_Ax3& frame, double radius, double from, double to);

/// (cells + 1)^2 points of every patch.
[[nodiscard]] std::vector<Eigen::Vector3d> pointsOf(const occt::ShapeFill& blend, int cells);

/// Largest distance of 16 points of every patch of one blend from the faces of another.
[[nodiscard]] double apart(const occt::ShapeFill& a, const occt::ShapeFill& b);

}  // namespace fairing::testing
