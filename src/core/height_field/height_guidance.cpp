// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/height_field/height_guidance.h"

#include "core/energy/guidance_samples.h"
#include "core/height_field/height_surface.h"

namespace fairing::height_field {
namespace {

using Eigen::Vector3d;

std::vector<EnergySquare> squaresOf(const energy::WeightedSample& sample, const PlaneFrame& frame) {
  const energy::GuidanceSample& guide = sample.guide;
  const Vector3d normal = frame.components(guide.normal);
  EnergySquare alongU, alongV, height;
  alongU.form[Hu] = alongV.form[Hv] = normal[2];
  alongU.right = -normal[0];
  alongV.right = -normal[1];
  // The energies have a factor of 1/2 before them, and so have these squares.
  alongU.weight = alongV.weight = sample.weight * guide.lambda;
  height.form[H] = 1.0;
  height.right = frame.coordinates(guide.point)[2];
  height.weight = sample.weight * guide.gamma;
  return {alongU, alongV, height};
}

}  // namespace

void addGuidance(HeightSystem& system,
                 const energy::Guidance& guidance,
                 const Heights& about,
                 const PlaneFrame& frame,
                 const ProjectedLoop& loop) {
  const auto isInside = [&](const Vector3d& point) {
    return loop.contains(frame.coordinates(point).head<2>());
  };
  energy::Guidance within = guidance;
  if (guidance.reference)  // nearest points on shapes are dear: none for what is trimmed away
    within.reference = [&](const Vector3d& near) {
      return isInside(near) ? guidance.reference(near) : energy::GuidanceSample{};
    };
  const spline::BsplineSurface current = surfaceOf(about, frame);
  const energy::NormalFeet feet(guidance, {current});
  for (const energy::WeightedSample& sample :
       energy::guidanceSamples(within, feet, system.knotsU(), system.knotsV(), current)) {
    if (!loop.contains({sample.u, sample.v})) continue;
    CellSquares squares;
    const JetBasis at = jetBasis(system.knotsU(), system.knotsV(), sample.u, sample.v);
    for (const EnergySquare& square : squaresOf(sample, frame)) squares.add(at, square);
    system.addEnergy(squares);
  }
}

}  // namespace fairing::height_field
