// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/assembly/assemble_guidance.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/boundary/continuity.h"
#include "core/energy/energy_kind.h"
#include "core/energy/guidance.h"
#include "core/layout/patch_layout.h"
#include "core/solver/guided_program.h"
#include "core/spline/bspline_surface.h"

namespace fairing {

/// Everything a caller may choose about an edit.
struct EditOptions {
  EnergyKind energy = EnergyKind::ThinPlate;  ///< ThinPlate or Membrane
  /// What stays along the border: the outer row of control points (G0), two rows (G1), three (G2).
  /// Empty = what the energy has a say in: G0 for the membrane, G1 for the thin plate.
  std::optional<Continuity> keep;
  /// Where it gives no normals, N is the old surface's; where it gives no points, S is the old
  /// surface.
  energy::Guidance guidance;
  int degree = 0;  ///< 0 = the surface's own; else 3 to 9, never below the surface's own
  int spans = 0;   ///< 0 = the surface's own; else at least so many along each direction, 1 to 64
};

/// The first thing wrong with the options: UnknownChoice, DegreeOutOfRange, SpansOutOfRange and the
/// codes of energy::validate().
[[nodiscard]] std::optional<Error> validate(const EditOptions& options);

/// The face on a surface that is larger than it, in the surface's parameters; empty = all of it.
/// Control points that have a say on its border or beyond stay.
struct EditRegion {
  /// Whether a rectangle lies on the face, its border not touched.
  std::function<bool(double u0, double u1, double v0, double v1)> contains;
  std::vector<Eigen::Vector2d> border;  ///< places along the border, where its move is measured
};

struct EditReport {
  analysis::GuidanceReport before, after;   ///< how well the old and the new surface follow
  double energyBefore = 0.0, energy = 0.0;  ///< the extended energy over a domain of area 1, mm^2
  double borderMove = 0.0;                  ///< largest move of the border, mm
  double borderTurn = 0.0;   ///< largest turn of the surface's normal along the border, degrees
  double largestMove = 0.0;  ///< of any point at equal parameters, mm
  double diagonal = 0.0;     ///< of the surface's control points, mm
  Continuity kept = Continuity::G1;
  int poles = 0;  ///< control points
  int moved = 0;  ///< those left free
  std::vector<analysis::Note> notes;
};

struct EditResult {
  spline::BsplineSurface surface;  ///< over the old surface's domain
  EditReport report;
};

/// A surface whose guidance changes: a slider moves, a handle is dragged. By one thread at a time.
class SurfaceEdit {
 public:
  /// Fails with the codes of validate() and NothingToMove.
  [[nodiscard]] static Result<SurfaceEdit> make(const spline::BsplineSurface& old,
                                                const EditOptions& options,
                                                const EditRegion& region = {});
  /// The surface under other guidance; unless `lookUp` asks for it, handles, curves and references
  /// stay where they were looked up before. Fails with the codes of energy::validate(), HandleOff,
  /// ReferenceOff and those of solver::GuidedProgram::solve().
  [[nodiscard]] Result<EditResult> under(const energy::Guidance& guidance, bool lookUp = true);
  /// The same, looked up again until that stands still; where a finish is asked for, not again,
  /// which a note tells. Fails with Cancelled, too.
  [[nodiscard]] Result<EditResult> settled(const energy::Guidance& guidance,
                                           Progress* progress = nullptr);

 private:
  SurfaceEdit(spline::BsplineSurface old, EditOptions options, EditRegion region);
  [[nodiscard]] int moved() const;
  Result<void> lookUp(const energy::Guidance& guidance);

  spline::BsplineSurface old_, start_, scaled_;  // as given; enriched; over its proportions
  EditOptions options_;
  EditRegion region_;
  layout::PatchLayout layout_;
  solver::QuadraticProgram program_;
  std::optional<solver::GuidedProgram> guided_;
  assembly::GuidanceSystem guide_;
  spline::BsplineSurface latest_;  // over its proportions
  std::optional<analysis::GuidanceReport> before_;
};

/// The surface of least extended energy ([WuYang2015] eq. 1 and 2) among those that keep the border
/// of the old one, written on its knots, raised and split as asked for. The domain is scaled to the
/// surface's proportions and an area of 1 for that, so lambda and gamma mean the same at every
/// size. Handles, curves and references are looked up near the old surface, then near the new one
/// until that stands still. Fails with the codes of
/// validate(), NothingToMove, HandleOff, ReferenceOff, those of solver::solve() and Cancelled.
[[nodiscard]] Result<EditResult> editSurface(const spline::BsplineSurface& old,
                                             const EditOptions& options,
                                             const EditRegion& region = {},
                                             Progress* progress = nullptr);

}  // namespace fairing
