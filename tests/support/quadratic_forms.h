// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Eigen/Core>
#include <functional>

#include "core/energy/guidance.h"
#include "core/layout/patch_layout.h"
#include "core/solver/quadratic_program.h"
#include "core/spline/bspline_surface.h"
#include "support/random_splines.h"

namespace fairing::testing {

/// A layout of one patch on given knots, no sides: points numbered as the poles.
[[nodiscard]] layout::PatchLayout freePatch(const spline::KnotVector& u,
                                            const spline::KnotVector& v);

/// 1/2 sum H_ij x_i . x_j.
[[nodiscard]] double quadraticForm(const solver::Sparse& stiffness, const spline::Poles& poles);

/// Integral over a surface's parameters by Gauss-Legendre with `points` a span and direction.
[[nodiscard]] double integral(const spline::BsplineSurface& surface,
                              int points,
                              const std::function<double(double u, double v)>& integrand);

/// The energies as [WuYang2015] eq. 1 and 2 have them with lambda = gamma = 0, integrated
/// numerically: the oracle of the assembled matrices.
[[nodiscard]] double membraneEnergy(const spline::BsplineSurface& surface);
[[nodiscard]] double thinPlateEnergy(const spline::BsplineSurface& surface);

/// lambda [(R_u . N)^2 + (R_v . N)^2] + gamma (R - S)^2, [WuYang2015] eq. 1.
[[nodiscard]] double guidedIntegrand(const spline::SurfaceJet& r,
                                     const Eigen::Vector3d& n,
                                     const Eigen::Vector3d& s,
                                     double lambda,
                                     double gamma);
/// A field of random unit normals, points and weights on a grid of 5 x 4 samples.
[[nodiscard]] energy::Guidance discreteGuidance(Random& random, double lambda, double gamma);
/// What a field on a grid adds to the energy of a patch over [0, a] x [0, b], [WuYang2015] eq. 5:
/// every sample weighs its share of the domain's area.
[[nodiscard]] double discreteEnergy(const spline::BsplineSurface& patch,
                                    const energy::Guidance& guidance);

/// The poles flattened as the solver numbers them, and back.
[[nodiscard]] Eigen::VectorXd flattened(const spline::Poles& poles);
[[nodiscard]] spline::Poles unflattened(const Eigen::VectorXd& flat);

/// A program that minimises `stiffness` with the outer `rows` rows of a patch's poles held.
[[nodiscard]] solver::QuadraticProgram holdingBorder(const spline::BsplineSurface& patch,
                                                     const solver::Sparse& stiffness,
                                                     int rows);

}  // namespace fairing::testing
