// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/energy_table.h"

#include <gmock/gmock.h>

#include <sstream>
#include <string>
#include <vector>

namespace fairing::text {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

FillResult filled(Continuity asked) {
  FillResult fill;
  analysis::SideReport side;
  side.asked = asked;
  fill.report.sides = {side};
  fill.report.largestGap = 3.2e-6;
  fill.report.largestAngle = 0.0031;
  fill.report.largestCornerAngle = 0.012;
  fill.report.largestCurvature = 0.043;
  fill.report.fairness.thinPlate = 5326.0;
  fill.report.fairness.totalCurvature = 1.769;
  fill.report.fairness.meanCurvatureGradient = 7.111e-4;
  fill.report.fairness.minimumVariation = 2.046e-3;
  fill.summary.totalTime = 1.4159;
  return fill;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(EnergyTable, HasAllValuesInALine) {
  const FillResult fill = filled(Continuity::G1);
  const auto lines = linesOf(table({{EnergyKind::MinimumVariation, &fill}}));
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[0], HasSubstr("MVS"));
  EXPECT_THAT(lines[0], Not(HasSubstr("curvature")));  // nobody asks for it
  for (const char* part :
       {"minimum-variation", "3.2", "0.012", "5326", "1.769", "0.0007111", "0.002046", "1.42"})
    EXPECT_THAT(lines[2], HasSubstr(part));
}

TEST(EnergyTable, HasCurvatureWhereAnySideAsksForIt) {
  const FillResult plain = filled(Continuity::G1), asking = filled(Continuity::G2);
  const std::string text =
      table({{EnergyKind::Membrane, &plain}, {EnergyKind::ThinPlate, &asking}});
  EXPECT_THAT(text, HasSubstr("curvature"));
  EXPECT_THAT(text, HasSubstr("4.3 %"));
}

TEST(EnergyTable, SaysWhyAnEnergyHasNoSurface) {
  const Error error{.code = ErrorCode::SystemSingular};
  const std::string text = table({{EnergyKind::Membrane, nullptr, &error}});
  EXPECT_THAT(text, HasSubstr("membrane"));
  EXPECT_THAT(text, HasSubstr("not determined"));
}

TEST(EnergyTable, ColumnsStandBelowTheirHeads) {
  const FillResult fill = filled(Continuity::G2);
  const auto lines = linesOf(table({{EnergyKind::ThinPlate, &fill}}));
  const auto endOf = [](const std::string& line, const std::string& word) {
    return line.find(word) + word.size();
  };
  EXPECT_EQ(endOf(lines[0], "thin plate"),
            endOf(lines[2], "5326") - 1);  // the degree sign has two bytes
  EXPECT_EQ(endOf(lines[0], "seconds"), endOf(lines[2], "1.42") - 1);
}

}  // namespace
}  // namespace fairing::text
