// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/span_hole.h"

#include <algorithm>

#include "core/assembly/assemble_energy.h"
#include "core/constraint/constraint_set.h"
#include "core/layout/build_layout.h"
#include "core/span/pass_through.h"

namespace fairing {
namespace {

// Points that the sides fix or solve for: nothing else may.
std::vector<char> takenPoints(const solver::QuadraticProgram& program) {
  std::vector<char> taken = program.fixed;
  for (const solver::ConstraintBlock& block : program.blocks)
    for (const solver::LinearRow& row : block.rows)
      for (const int point : row.points) taken[static_cast<std::size_t>(point)] = 1;
  return taken;
}

// Beside the stiffness that a point has by the energy.
constexpr double kPull = 1e3;

void hold(const HeldPoints& held, solver::QuadraticProgram& program) {
  for (std::size_t k = 0; k < held.points.size(); ++k) {
    const int point = held.points[k];
    const Eigen::RowVector3d value = held.values.row(static_cast<Eigen::Index>(k));
    if (held.firmly) {
      program.fixed[static_cast<std::size_t>(point)] = 1;
      program.values.row(point) = value;
      continue;
    }
    const double pull = kPull * program.stiffness.coeff(point, point);
    program.stiffness.coeffRef(point, point) += pull;
    for (int c = 0; c < 3; ++c) program.load[3 * point + c] += pull * value[c];
  }
}

}  // namespace

Patches makePatches(const layout::PatchLayout& layout, const solver::Points& points) {
  Patches patches;
  for (const layout::LayoutPatch& from : layout.patches) {
    spline::Poles poles(static_cast<Eigen::Index>(from.points.size()), 3);
    for (std::size_t k = 0; k < from.points.size(); ++k)
      poles.row(static_cast<Eigen::Index>(k)) = points.row(from.points[k]);
    patches.push_back({from.u, from.v, std::move(poles)});
  }
  return patches;
}

solver::Points pointsOf(const layout::PatchLayout& layout, const Patches& patches) {
  solver::Points points(layout.pointCount, 3);
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t k = 0; k < layout.patches[p].points.size(); ++k)
      points.row(layout.patches[p].points[k]) = patches[p].poles.row(static_cast<Eigen::Index>(k));
  return points;
}

solver::Points pointsOn(const layout::PatchLayout& layout, const Patches& coarse) {
  solver::Points points(layout.pointCount, 3);
  for (std::size_t p = 0; p < coarse.size(); ++p) {
    const layout::LayoutPatch& patch = layout.patches[p];
    const auto raised = spline::raiseDegree(coarse[p],
                                            patch.u.degree() - coarse[p].u.degree(),
                                            patch.v.degree() - coarse[p].v.degree());
    const spline::Poles poles = spline::refinedTo(raised, patch.u, patch.v).poles;
    for (std::size_t k = 0; k < patch.points.size(); ++k)
      points.row(patch.points[k]) = poles.row(static_cast<Eigen::Index>(k));
  }
  return points;
}

layout::PatchLayout layoutOf(const layout::LayoutPlan& plan, const Patches& patches) {
  const layout::Strips strips = layout::stripsOf(plan.mesh);
  std::vector<spline::KnotVector> knots(static_cast<std::size_t>(strips.count));
  for (std::size_t q = 0; q < patches.size(); ++q)
    for (std::size_t d = 0; d < 2; ++d) {
      const layout::StripUse use = strips.uses[q][d];
      const spline::KnotVector own = (d == 0 ? patches[q].u : patches[q].v).mapped(0.0, 1.0);
      knots[static_cast<std::size_t>(use.strip)] = use.reversed ? own.reversed() : own;
    }
  return layout::buildLayout(plan, std::move(knots));
}

Result<solver::QuadraticProgram> makeProgram(const layout::LayoutPlan& plan,
                                             const layout::PatchLayout& layout,
                                             EnergyKind kind,
                                             const Aim& aim,
                                             const std::vector<InnerConstraint>& through) {
  auto constraints =
      constraint::constrainSides(plan.cut.loop, layout, aim.about ? &*aim.about : nullptr);
  if (!constraints) return fail(constraints.error());
  solver::QuadraticProgram program;
  program.stiffness = assembly::assembleEnergy(layout, energy::energyTerms(kind));
  if (aim.shape) program.load = solver::flat(solver::Points(program.stiffness * *aim.shape));
  program.fixed = std::move(constraints->fixed);
  program.values = std::move(constraints->values);
  hold(aim.held, program);
  program.ties = std::move(constraints->ties);
  program.blocks = std::move(constraints->blocks);
  if (aim.about && !through.empty())
    for (solver::TieBlock& block :
         passThrough(layout, makePatches(layout, *aim.about), through, takenPoints(program)))
      program.ties.push_back(std::move(block));
  return program;
}

bool isIterated(const layout::LayoutPlan& plan, const FillOptions& options) {
  const auto& sides = plan.cut.loop.sides;
  const bool curvedSeams = plan.inner == Continuity::G2 && plan.mesh.quads.size() > 1;
  return !options.through.empty() || curvedSeams ||
         std::any_of(sides.begin(), sides.end(), [](const boundary::BoundarySide& side) {
           return side.continuity == Continuity::G2;
         });
}

std::optional<Error> fieldMisplaced(const energy::Guidance& guidance,
                                    const layout::PatchLayout& layout) {
  if (!guidance.hasField() || layout.patches.size() == 1) return std::nullopt;
  return Error{.code = ErrorCode::FieldManyPatches,
               .value = static_cast<double>(layout.patches.size())};
}

}  // namespace fairing
