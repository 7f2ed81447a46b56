// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/span/fill_options.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

namespace fairing {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct BadOption {
  const char* name;
  std::function<void(FillOptions&)> spoil;
  ErrorCode code;
};

class BadOptions : public ::testing::TestWithParam<BadOption> {};

TEST_P(BadOptions, AreNamed) {
  FillOptions options;
  GetParam().spoil(options);
  const auto error = validate(options);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, GetParam().code);
}

energy::NormalHandle handle(double weight, double radius) {
  return {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), weight, radius};
}

INSTANTIATE_TEST_SUITE_P(
    FillOptions,
    BadOptions,
    ::testing::Values(
        BadOption{"GapNegative",
                  [](auto& o) { o.tolerance.gap = -1e-6; },
                  ErrorCode::ToleranceNotPositive},
        BadOption{
            "GapNan", [](auto& o) { o.tolerance.gap = kNan; }, ErrorCode::ToleranceNotPositive},
        BadOption{"RelativeGapZero",
                  [](auto& o) { o.tolerance.relativeGap = 0.0; },
                  ErrorCode::ToleranceNotPositive},
        BadOption{
            "AngleZero", [](auto& o) { o.tolerance.angle = 0.0; }, ErrorCode::AngleNotPositive},
        BadOption{
            "AngleNan", [](auto& o) { o.tolerance.angle = kNan; }, ErrorCode::AngleNotPositive},
        BadOption{"CornerAngleNegative",
                  [](auto& o) { o.tolerance.cornerAngle = -1.0; },
                  ErrorCode::AngleNotPositive},
        BadOption{
            "LambdaNegative", [](auto& o) { o.guidance.lambda = -1.0; }, ErrorCode::WeightNegative},
        BadOption{
            "LambdaNan", [](auto& o) { o.guidance.lambda = kNan; }, ErrorCode::WeightNegative},
        BadOption{
            "GammaNegative", [](auto& o) { o.guidance.gamma = -1.0; }, ErrorCode::WeightNegative},
        BadOption{"GammaInfinite",
                  [](auto& o) { o.guidance.gamma = kInfinity; },
                  ErrorCode::WeightNegative},
        BadOption{"HandleWeightNegative",
                  [](auto& o) { o.guidance.handles = {handle(-1.0, 1.0)}; },
                  ErrorCode::WeightNegative},
        BadOption{
            "DegreeTooLowForTheEnergy", [](auto& o) { o.degree = 2; }, ErrorCode::DegreeTooLow},
        BadOption{"DegreeTooLow",
                  [](auto& o) {
                    o.degree = 2;
                    o.energy = EnergyKind::ThinPlate;
                  },
                  ErrorCode::DegreeOutOfRange},
        BadOption{"QuadraturePointsTooMany",
                  [](auto& o) { o.quadrature.points = 33; },
                  ErrorCode::QuadratureOutOfRange},
        BadOption{"QuadraturePointsNegative",
                  [](auto& o) { o.quadrature.points = -1; },
                  ErrorCode::QuadratureOutOfRange},
        BadOption{"DegreeTooHigh", [](auto& o) { o.degree = 10; }, ErrorCode::DegreeOutOfRange},
        BadOption{"PolesTooFew", [](auto& o) { o.maxPoles = 1; }, ErrorCode::ControlPointLimit}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(FillOptions, DefaultsAreValid) {
  EXPECT_FALSE(validate({}).has_value());
}

TEST(FillOptions, ErrorsSayWhichWeightAndItsValue) {
  FillOptions options;
  options.guidance.gamma = -2.0;
  const auto error = validate(options);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->detail, "gamma");
  EXPECT_EQ(error->value, -2.0);
}

}  // namespace
}  // namespace fairing
