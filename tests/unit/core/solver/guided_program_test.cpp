// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/solver/guided_program.h"

#include <gmock/gmock.h>

#include "support/matchers.h"

namespace fairing::solver {
namespace {

using namespace ::fairing::testing;  // NOLINT: matchers
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kPoints = 9;

// Symmetric and positive definite, the same at every call with the same seed.
MatrixXd definite(unsigned seed, Index size) {
  std::srand(seed);
  const MatrixXd a = MatrixXd::Random(size, size);
  return a * a.transpose() + MatrixXd::Identity(size, size);
}

QuadraticProgram someProgram() {
  QuadraticProgram program;
  program.stiffness = definite(1, kPoints).sparseView();
  program.load = VectorXd::LinSpaced(3 * kPoints, -1.0, 2.0);
  program.fixed.assign(kPoints, 0);
  program.fixed[0] = 1;
  program.values = Points::Constant(kPoints, 3, 0.4);
  program.ties = {{{{{1, 2, 3}, {1.0, -2.0, 1.0}, Eigen::Vector3d(0.1, 0.0, 0.2)}}, {2}}};
  program.blocks = {{{{{4, 5}, {Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(0, 1, -1)}, 0.3}}, {4}}};
  return program;
}

struct Guide {
  Sparse normals = definite(2, 3 * kPoints).sparseView();
  Sparse points = definite(3, kPoints).sparseView();
  VectorXd load = VectorXd::LinSpaced(3 * kPoints, 3.0, -1.0);
};

// The same by one solve of a program that holds the guide.
Points atOnce(const Guide& guide, double lambda, double gamma) {
  QuadraticProgram program = someProgram();
  program.coupled = lambda * guide.normals + gamma * threefold(guide.points);
  program.load += gamma * guide.load;
  const auto solution = solve(program);
  EXPECT_TRUE(solution.has_value());
  return solution ? solution->points : Points();
}

TEST(GuidedProgram, IsTheProgramWithItsGuide) {
  const Guide guide;
  GuidedProgram guided(someProgram());
  guided.setGuide(guide.normals, guide.points, guide.load);
  for (const auto& [lambda, gamma] : {std::pair{1.0, 0.0}, {3.0, 2.0}, {0.0, 50.0}, {0.5, 0.1}}) {
    const auto solution = guided.solve(lambda, gamma);
    ASSERT_TRUE(solution.has_value());
    EXPECT_THAT(solution->points, IsNear(atOnce(guide, lambda, gamma), 1e-10));
  }
}

TEST(GuidedProgram, WithoutAGuideIsTheProgram) {
  GuidedProgram guided(someProgram());
  const auto alone = guided.solve(7.0, 7.0), plain = solve(someProgram());
  ASSERT_TRUE(alone && plain);
  EXPECT_THAT(alone->points, IsNear(plain->points, 1e-10));
  EXPECT_EQ(alone->unknowns, plain->unknowns);
  EXPECT_EQ(alone->constraints, plain->constraints);
}

TEST(GuidedProgram, TakesAnotherGuide) {
  Guide guide;
  GuidedProgram guided(someProgram());
  guided.setGuide(guide.normals, guide.points, guide.load);
  ASSERT_TRUE(guided.solve(1.0, 1.0).has_value());
  guide.normals = Sparse(3 * kPoints, 3 * kPoints);  // couples fewer coordinates
  guide.load *= -2.0;
  guided.setGuide(guide.normals, guide.points, guide.load);
  EXPECT_THAT(guided.solve(1.0, 4.0)->points, IsNear(atOnce(guide, 1.0, 4.0), 1e-10));
}

}  // namespace
}  // namespace fairing::solver
