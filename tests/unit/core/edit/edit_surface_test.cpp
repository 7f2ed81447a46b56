// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/edit/edit_surface.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "support/matchers.h"
#include "support/quadratic_forms.h"
#include "support/random_splines.h"

namespace fairing {
namespace {

using namespace ::fairing::testing;  // NOLINT: splines and quadratic forms
using Eigen::Vector3d;
using spline::BsplineSurface;
using spline::KnotVector;

constexpr double kSide = 40.0;  // mm

/// A wavy square over the unit square, bi-quintic.
BsplineSurface wavy(double scale = 1.0) {
  const KnotVector knots = KnotVector::bezier(5);
  return interpolated(
      [scale](double u, double v) {
        return Vector3d(scale * kSide * u,
                        scale * kSide * v,
                        scale * (4.0 * std::sin(3.0 * u) * std::cos(2.0 * v) + 2.0 * u * v));
      },
      knots,
      knots);
}

/// Unit normals of the wavy square with a swelling in its middle that leaves its border and the
/// slopes there alone: a surface through the same border has them.
Vector3d swellingNormal(double u, double v) {
  static const BsplineSurface base = wavy();
  const auto bell = [](double t) { return t * t * (1.0 - t) * (1.0 - t); };
  const auto slope = [](double t) { return 2.0 * t * (1.0 - t) * (1.0 - 2.0 * t); };
  constexpr double kHeight = 8.0 * 256.0;  // 8 mm in the middle
  const spline::SurfaceJet jet = base.jet(u, v);
  const Vector3d du = jet.u + Vector3d(0, 0, kHeight * slope(u) * bell(v));
  const Vector3d dv = jet.v + Vector3d(0, 0, kHeight * bell(u) * slope(v));
  return du.cross(dv).normalized();
}

energy::DiscreteGuidance gridOf(int n, const PointFunction& normal) {
  energy::DiscreteGuidance grid;
  grid.n = grid.m = n;
  const Eigen::Index count = Eigen::Index(n + 1) * (n + 1);
  grid.normals.resize(count, 3);
  grid.points = spline::Poles::Zero(count, 3);
  grid.lambda = Eigen::VectorXd::Ones(count);
  grid.gamma = Eigen::VectorXd::Zero(count);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      grid.normals.row(i * (n + 1) + j) = normal(double(i) / n, double(j) / n).transpose();
  return grid;
}

EditOptions swelling(EnergyKind energy, double lambda, double gamma = 0.0) {
  EditOptions options;
  options.energy = energy;
  options.guidance.lambda = lambda;
  options.guidance.gamma = gamma;
  options.guidance.discrete = gridOf(12, swellingNormal);
  options.degree = 8;
  return options;
}

class BothEnergies : public ::testing::TestWithParam<EnergyKind> {};

// The acceptance of the paper's idea: more weight, closer to the guide.
TEST_P(BothEnergies, MoreLambdaFollowsTheNormalsMoreClosely) {
  double before = 90.0;
  for (const double lambda : {0.0, 1.0, 10.0, 50.0, 500.0}) {
    const auto edit = editSurface(wavy(), swelling(GetParam(), lambda));
    ASSERT_TRUE(edit.has_value());
    EXPECT_LT(edit->report.after.rmsAngle, before - 1e-3) << lambda;
    EXPECT_EQ(edit->report.after.normals, 13 * 13);
    before = edit->report.after.rmsAngle;
  }
}

TEST_P(BothEnergies, MoreGammaStaysNearerToTheReference) {
  double before = kSide;
  for (const double gamma : {0.0, 10.0, 100.0, 1000.0}) {
    const auto edit = editSurface(wavy(), swelling(GetParam(), 10.0, gamma));
    ASSERT_TRUE(edit.has_value());
    EXPECT_LT(edit->report.after.rmsDistance, before) << gamma;
    before = edit->report.after.rmsDistance;
  }
  EXPECT_LT(before, 0.02 * kSide);
}

TEST_P(BothEnergies, InfiniteGammaGivesTheReferenceBack) {
  const BsplineSurface old = wavy();
  const auto edit = editSurface(old, swelling(GetParam(), 0.0, 1e9));
  ASSERT_TRUE(edit.has_value());
  EXPECT_LT(edit->report.largestMove, 1e-5 * kSide);
}

TEST_P(BothEnergies, TheEnergyFallsAndNoPerturbationIsBetter) {
  EditOptions options = swelling(GetParam(), 20.0, 5.0);
  const auto edit = editSurface(wavy(), options);
  ASSERT_TRUE(edit.has_value());
  EXPECT_LT(edit->report.energy, edit->report.energyBefore);
  // An edit of the result finds nothing to gain where S is still the same.
  energy::Guidance& g = options.guidance;
  g.discrete->points = spline::Poles::Zero(13 * 13, 3);
  g.discrete->gamma.setOnes();
  for (int i = 0; i <= 12; ++i)
    for (int j = 0; j <= 12; ++j)
      g.discrete->points.row(i * 13 + j) = wavy().evaluate(i / 12.0, j / 12.0).transpose();
  const auto once = editSurface(wavy(), options);
  ASSERT_TRUE(once.has_value());
  const auto twice = editSurface(once->surface, options);
  ASSERT_TRUE(twice.has_value());
  // Its proportions, and with them the domain, have changed a little.
  EXPECT_LT(twice->report.largestMove, 0.02 * once->report.largestMove);
}

INSTANTIATE_TEST_SUITE_P(Energies,
                         BothEnergies,
                         ::testing::Values(EnergyKind::Membrane, EnergyKind::ThinPlate),
                         [](const auto& instance) {
                           return instance.param == EnergyKind::Membrane ? "Membrane" : "ThinPlate";
                         });

struct Kept {
  Continuity keep;
  int rows;
};

class KeepsRows : public ::testing::TestWithParam<Kept> {};

TEST_P(KeepsRows, ExactlyWhateverTheWeights) {
  for (const double lambda : {0.0, 500.0}) {
    EditOptions options = swelling(EnergyKind::ThinPlate, lambda);
    options.keep = GetParam().keep;
    const BsplineSurface old = wavy();
    const auto edit = editSurface(old, options);
    ASSERT_TRUE(edit.has_value());
    const BsplineSurface raised = spline::raiseDegree(old, 3, 3);
    const int n = raised.u.poleCount();
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (std::min({i, j, n - 1 - i, n - 1 - j}) < GetParam().rows) {
          EXPECT_EQ(edit->surface.pole(i, j), raised.pole(i, j));
        }
    EXPECT_LE(edit->report.borderMove, 1e-12 * edit->report.diagonal);
    if (lambda > 0.0) {
      EXPECT_GT(edit->report.largestMove, 0.001 * kSide);
    }
    if (GetParam().rows > 1) {
      EXPECT_LE(edit->report.borderTurn, 1e-10);
    }
    if (GetParam().rows == 3) {  // the curvature, too
      for (const double t : {0.0, 0.3, 0.9, 1.0}) {
        EXPECT_THAT(edit->surface.evaluate(0.0, t, 2, 0), IsNear(old.evaluate(0.0, t, 2, 0), 1e-9));
        EXPECT_THAT(edit->surface.evaluate(t, 1.0, 0, 2), IsNear(old.evaluate(t, 1.0, 0, 2), 1e-9));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Continuities,
    KeepsRows,
    ::testing::Values(Kept{Continuity::G0, 1}, Kept{Continuity::G1, 2}, Kept{Continuity::G2, 3}),
    [](const auto& instance) { return "G" + std::to_string(instance.param.rows - 1); });

TEST(EditSurface, KeepsWhatTheEnergyHasASayIn) {
  EditOptions options;
  options.degree = 8;
  EXPECT_EQ(editSurface(wavy(), options)->report.kept, Continuity::G1);
  options.energy = EnergyKind::Membrane;
  EXPECT_EQ(editSurface(wavy(), options)->report.kept, Continuity::G0);
}

// Without guidance the classical functionals are left: harmonic and biharmonic patches of low
// enough degree are their own minimisers. Heights that change their sign when u and v are swapped
// make the domain square.
TEST(EditSurface, WithoutWeightsGivesHarmonicAndBiharmonicPatchesBack) {
  const KnotVector knots = KnotVector::bezier(5);
  const auto harmonic = [](double u, double v) {
    const double x = u - 0.5, y = v - 0.5;
    return Vector3d(x, y, 0.3 * (x * x - y * y) + 0.7 * (x * x * x * y - x * y * y * y));
  };
  const auto biharmonic = [](double u, double v) {
    const double x = u - 0.5, y = v - 0.5;
    const double cubic = x * x * x - 3.0 * x * y * y - y * y * y + 3.0 * x * x * y;
    return Vector3d(x, y, (x * x + y * y) * (cubic + x * x - y * y));
  };
  EditOptions options;
  options.energy = EnergyKind::Membrane;
  const auto first = editSurface(interpolated(harmonic, knots, knots), options);
  ASSERT_TRUE(first.has_value());
  EXPECT_LT(first->report.largestMove, 1e-12);
  options.energy = EnergyKind::ThinPlate;
  const auto second = editSurface(interpolated(biharmonic, knots, knots), options);
  ASSERT_TRUE(second.has_value());
  EXPECT_LT(second->report.largestMove, 1e-12);
}

TEST(EditSurface, FollowsItsOwnNormalsUnlessOthersAreGiven) {
  EditOptions options;
  options.energy = EnergyKind::Membrane;
  options.degree = 8;
  const auto free = editSurface(wavy(), options);
  options.guidance.lambda = 1e4;
  const auto guided = editSurface(wavy(), options);
  ASSERT_TRUE(free.has_value() && guided.has_value());
  EXPECT_LT(guided->report.before.rmsAngle, 1e-5);
  EXPECT_LT(guided->report.after.rmsAngle, 0.05 * free->report.after.rmsAngle);
  EXPECT_LT(guided->report.largestMove, 0.1 * free->report.largestMove);
}

TEST(EditSurface, MeansTheSameAtEverySize) {
  const auto small = editSurface(wavy(), swelling(EnergyKind::ThinPlate, 30.0, 4.0));
  const auto large = editSurface(wavy(100.0), swelling(EnergyKind::ThinPlate, 30.0, 4.0));
  ASSERT_TRUE(small.has_value() && large.has_value());
  // Rounding times the condition of a thin plate of degree 8, about 1e5, at 4 m.
  EXPECT_THAT(large->surface.poles, IsNear(spline::Poles(100.0 * small->surface.poles), 1e-7));
}

TEST(EditSurface, KeepsTheDomainAndTheKnots) {
  BsplineSurface old = wavy();
  old.u = old.u.mapped(-3.0, 7.0);
  EditOptions options;
  options.spans = 3;
  const auto edit = editSurface(old, options);
  ASSERT_TRUE(edit.has_value());
  EXPECT_EQ(edit->surface.u.first(), -3.0);
  EXPECT_EQ(edit->surface.u.last(), 7.0);
  EXPECT_EQ(edit->surface.u.breaks().size(), 4U);
  EXPECT_EQ(edit->surface.v.degree(), 5);
}

// [WuYang2015] section 4 against section 3 on the same field. The grid's plain sum weighs the rim
// as much as the inside, so it is of first order.
TEST(EditSurface, TheDiscreteFormTendsToTheContinuousOne) {
  const KnotVector knots = KnotVector::bezier(3);
  const PointFunction field = [](double u, double v) {
    return Vector3d(0.5 * (u - 0.5), 0.6 * (v - 0.4) * u, 1.0);
  };
  EditOptions options;
  options.energy = EnergyKind::ThinPlate;
  options.guidance.lambda = 20.0;
  options.degree = 7;
  options.guidance.continuous = {interpolated(field, knots, knots)};
  const auto exact = editSurface(wavy(), options);
  ASSERT_TRUE(exact.has_value());
  options.guidance.continuous.reset();
  std::vector<double> distances;
  for (const int n : {16, 32, 64}) {
    options.guidance.discrete = gridOf(n, field);
    const auto sampled = editSurface(wavy(), options);
    ASSERT_TRUE(sampled.has_value());
    double distance = 0.0;
    for (const double u : evenParameters(exact->surface.u, 21))
      for (const double v : evenParameters(exact->surface.v, 21))
        distance = std::max(
            distance, (sampled->surface.evaluate(u, v) - exact->surface.evaluate(u, v)).norm());
    distances.push_back(distance);
  }
  for (std::size_t k = 1; k < distances.size(); ++k)
    EXPECT_NEAR(std::log2(distances[k - 1] / distances[k]), 1.0, 0.15) << k;
  EXPECT_LT(distances.back(), 1e-3 * exact->report.diagonal);
}

TEST(EditSurface, AHandleTurnsTheSurfaceWhereItActs) {
  const BsplineSurface old = wavy();
  const Vector3d at = old.evaluate(0.5, 0.5), wish = Vector3d(0.5, 0.0, 1.0).normalized();
  EditOptions options;
  options.degree = 8;
  options.guidance.lambda = 1e4;
  options.guidance.gamma = 1.0;
  options.guidance.handles = {{at, wish, 1.0, 0.25 * kSide}};
  const auto edit = editSurface(old, options);
  ASSERT_TRUE(edit.has_value());
  EXPECT_LT(edit->report.after.rmsAngle, 0.2 * edit->report.before.rmsAngle);
  EXPECT_LE(edit->report.borderMove, 1e-12 * edit->report.diagonal);
}

TEST(EditSurface, AReferenceThatCoversAPartGuidesThere) {
  EditOptions options;
  options.guidance.gamma = 100.0;
  options.guidance.reference = [](const Vector3d& near) {
    const double known = near.x() < 0.5 * kSide ? 1.0 : 0.0;
    return energy::GuidanceSample{Vector3d::UnitZ(), {near.x(), near.y(), 3.0}, known, known};
  };
  const auto edit = editSurface(wavy(), options);
  ASSERT_TRUE(edit.has_value());
  EXPECT_NEAR(edit->report.after.covered, 0.5, 0.1);
  ASSERT_EQ(edit->report.notes.size(), 1U);
  EXPECT_EQ(edit->report.notes[0].code, analysis::NoteCode::ReferenceShort);
  EXPECT_NEAR(edit->report.notes[0].value, 0.5, 0.1);
  options.guidance.reference = [](const Vector3d&) { return energy::GuidanceSample{}; };
  EXPECT_THAT(editSurface(wavy(), options), FailsWith(ErrorCode::ReferenceOff));
}

// Guided to a level plane; every look at it does something.
EditOptions guidedTo(const std::function<void()>& whenLooked) {
  EditOptions options;
  options.guidance.gamma = 100.0;
  options.guidance.reference = [whenLooked](const Vector3d& near) {
    whenLooked();
    return energy::GuidanceSample{Vector3d::UnitZ(), {near.x(), near.y(), 3.0}, 1.0, 1.0};
  };
  return options;
}

TEST(EditSurface, CanBeCancelledBetweenTwoLooks) {
  // The first look at the reference asks for the abort.
  Progress progress;
  const EditOptions options = guidedTo([&] { progress.requestAbort(); });
  EXPECT_THAT(editSurface(wavy(), options, {}, &progress), FailsWith(ErrorCode::Cancelled));
  EXPECT_GT(progress.fraction(), 0.0);
  EXPECT_LT(progress.fraction(), 0.5);
}

TEST(EditSurface, GivesTheLatestLookWhereAFinishIsAskedFor) {
  // The first look at the reference asks for it.
  Progress progress;
  const EditOptions options = guidedTo([&] { progress.requestFinish(); });
  const auto stopped = editSurface(wavy(), options, {}, &progress);
  ASSERT_TRUE(stopped.has_value());
  ASSERT_EQ(stopped->report.notes.size(), 1U);
  EXPECT_EQ(stopped->report.notes[0].code, analysis::NoteCode::LookUpsStopped);
  EXPECT_EQ(stopped->report.notes[0].value, 1.0);
  auto one = SurfaceEdit::make(wavy(), options);
  ASSERT_TRUE(one.has_value());
  const auto look = one->under(options.guidance);
  ASSERT_TRUE(look.has_value());
  EXPECT_EQ(stopped->surface.poles, look->surface.poles);
}

TEST(EditSurface, MovesOnlyWhatLiesOnItsRegion) {
  EditOptions options = swelling(EnergyKind::ThinPlate, 500.0);
  options.spans = 6;
  EditRegion region;
  region.contains = [](double u0, double u1, double v0, double v1) {
    return u0 > 0.2 && u1 < 0.9 && v0 > 0.3 && v1 < 0.95;
  };
  const BsplineSurface old = spline::refinedTo(wavy(), wavy().u, wavy().v);
  options.degree = 0;
  const auto none = editSurface(old, options, region);
  EXPECT_THAT(none, FailsWith(ErrorCode::NothingToMove));
  options.spans = 24;
  region.border = {{0.2, 0.5}, {0.9, 0.5}, {0.5, 0.3}, {0.5, 0.95}};
  const auto edit = editSurface(old, options, region);
  ASSERT_TRUE(edit.has_value());
  EXPECT_LE(edit->report.borderMove, 1e-12 * edit->report.diagonal);
  EXPECT_GT(edit->report.largestMove, 0.001 * kSide);
  for (const double t : {0.0, 0.5, 1.0})
    EXPECT_THAT(edit->surface.evaluate(0.1, t), IsNear(old.evaluate(0.1, t), 1e-12 * kSide));
}

TEST(EditSurface, TellsWhatIsWrong) {
  const auto failing = [](const auto& change) {
    EditOptions options = swelling(EnergyKind::ThinPlate, 1.0);
    change(options);
    return editSurface(wavy(), options);
  };
  EXPECT_THAT(failing([](EditOptions& o) { o.energy = EnergyKind::MeanCurvatureGradient; }),
              FailsWith(ErrorCode::UnknownChoice));
  EXPECT_THAT(failing([](EditOptions& o) { o.degree = 2; }),
              FailsWith(ErrorCode::DegreeOutOfRange));
  EXPECT_THAT(failing([](EditOptions& o) { o.spans = 65; }), FailsWith(ErrorCode::SpansOutOfRange));
  EXPECT_THAT(failing([](EditOptions& o) { o.guidance.lambda = -1.0; }),
              FailsWith(ErrorCode::WeightNegative));
  EXPECT_THAT(failing([](EditOptions& o) { o.guidance.discrete->normals.row(3).setZero(); }),
              FailsWith(ErrorCode::NormalZero));
  EXPECT_THAT(failing([](EditOptions& o) { o.guidance.discrete->n = 5; }),
              FailsWith(ErrorCode::FieldSize));
  EXPECT_THAT(failing([](EditOptions& o) {
                o.guidance.handles = {{Vector3d(500, 0, 0), Vector3d::UnitZ(), 1.0, 5.0}};
              }),
              FailsWith(ErrorCode::HandleOff));
  EXPECT_THAT(failing([](EditOptions& o) {
                o.degree = 0;
                o.keep = Continuity::G2;
              }),
              FailsWith(ErrorCode::NothingToMove));
}

}  // namespace
}  // namespace fairing
