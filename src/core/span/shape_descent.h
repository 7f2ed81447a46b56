// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>

#include "core/assembly/assemble_shape_energy.h"
#include "core/layout/patch_layout.h"
#include "core/shape_energy/shape_energy.h"
#include "core/solver/free_matrix.h"
#include "core/solver/pattern_factor.h"
#include "core/solver/quadratic_program.h"

namespace fairing {

/// How the parametrisation, which an energy of the shape does not see, is kept from drifting.
/// Without unit.
struct ShapeHold {
  double step = 0.0;    ///< weight of each step's displacements along the surface
  double anchor = 0.0;  ///< weight of the displacements along the surface since the start
};

/// A step that was taken, or tried in vain.
struct ShapeStep {
  bool fell = false;
  double before = 0.0;  ///< what had to fall: the energy and what the anchor adds
  double energy = 0.0;  ///< afterwards; not finite where a patch has no normal
  double anchor = 0.0;  ///< afterwards, in the energy's unit
  double length = 0.0;  ///< root of the mean square of the displacements of points, mm
};

/// Where the time of the steps went, seconds.
struct StageTimes {
  double assembly = 0.0;       ///< models of the energy in the free directions
  double factorisation = 0.0;  ///< factors and the steps they give
  double evaluation = 0.0;     ///< energies alone, folds
};

/// Damped Gauss-Newton and Newton steps on an energy of the shape. Every step keeps the constraints
/// of a program exactly, lets the energy and what the anchor adds to it fall, and folds no patch.
class ShapeDescent {
 public:
  /// `start`: points that the anchor holds; `size`: the hole's, mm; `quadrature`: 0 points = chosen
  /// from the degree. The layout and the energy have to outlive it.
  ShapeDescent(const layout::PatchLayout& layout,
               const shape_energy::ShapeEnergy& energy,
               const solver::QuadraticProgram& program,
               const solver::Points& start,
               double size,
               const ShapeHold& hold,
               const spline::QuadratureRule& quadrature);

  /// The energy alone; not finite where a patch has no normal.
  [[nodiscard]] double energyAt(const solver::Points& points) const;
  /// What the anchor adds, in the energy's unit.
  [[nodiscard]] double anchorAt(const solver::Points& points) const;
  /// Takes a step from points that meet the constraints, unless none lets the sum fall:
  /// newtonStep() where Gauss-Newton's have become slow and there is one.
  [[nodiscard]] ShapeStep step(solver::Points& points);
  /// Takes a step with all second derivatives, undamped, if these are positive definite and it lets
  /// the sum fall. Near a minimum the distance to it is squared, whether residuals vanish or not.
  [[nodiscard]] std::optional<ShapeStep> newtonStep(solver::Points& points);
  [[nodiscard]] const StageTimes& times() const { return times_; }

 private:
  struct Model;
  struct Place;
  struct Trial;

  [[nodiscard]] Place placeAt(const solver::Points& points);
  [[nodiscard]] solver::Sparse damped(const Model& model, double damping) const;
  [[nodiscard]] std::optional<Trial> newtonFrom(const Place& from);
  [[nodiscard]] Model modelOf(std::vector<assembly::ShapeElement> elements,
                              const solver::Points& points) const;
  [[nodiscard]] std::optional<Trial> tried(const solver::Sparse& matrix,
                                           const Model& model,
                                           const Place& from);

  const layout::PatchLayout& layout_;
  const shape_energy::ShapeEnergy& energy_;
  solver::Sparse freedom_;
  solver::FreeMatrix free_;
  solver::Sparse displacement_;  // the integral of |d|^2 in the free directions
  solver::PatternFactor factor_;
  double size_, scale_;
  spline::QuadratureRule quadrature_;
  double pinning_;
  solver::Points start_;
  std::vector<assembly::ShapeElement> anchor_;  // without its weight, or empty
  double anchorWeight_;
  double damping_ = 0.0;
  double newtonBelow_;
  bool isSlow_ = false;
  StageTimes times_;
};

}  // namespace fairing
