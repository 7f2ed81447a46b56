// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/guide_json.h"

#include <gmock/gmock.h>

namespace fairing::text {
namespace {

using ::testing::HasSubstr;

Result<energy::Guidance> read(const char* text) {
  return guidanceFrom(nlohmann::json::parse(text), "guide.json");
}

std::string whyNot(const char* text) {
  const auto guidance = read(text);
  if (guidance) return {};
  EXPECT_EQ(guidance.error().code, ErrorCode::GuideInvalid);
  return guidance.error().detail;
}

TEST(GuideJson, ReadsHandlesWithOrWithoutAName) {
  for (const char* text :
       {R"([{"point": [1, 2, 3], "normal": [0, 0, 2], "radius": 5}])",
        R"({"normals": [{"point": [1, 2, 3], "normal": [0, 0, 2], "radius": 5, "weight": 1}]})"}) {
    const auto guidance = read(text);
    ASSERT_TRUE(guidance.has_value());
    ASSERT_EQ(guidance->handles.size(), 1U);
    EXPECT_EQ(guidance->handles[0].point, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(guidance->handles[0].normal, Eigen::Vector3d::UnitZ());
    EXPECT_EQ(guidance->handles[0].weight, 1.0);
    EXPECT_EQ(guidance->handles[0].radius, 5.0);
  }
}

TEST(GuideJson, ReadsAGridOfNormals) {
  const auto guidance = read(R"({"field": {"n": 1, "m": 2, "corners": [[0,0,0],[1,0,0],[0,1,0]],
      "normals": [[0,0,1],[0,0,2],[0,3,0],[1,0,0],[0,0,0],[0,1,0]], "weights": [1,1,1,1,0,2]}})");
  ASSERT_TRUE(guidance.has_value());
  const energy::DiscreteGuidance& grid = *guidance->discrete;
  EXPECT_EQ(grid.n, 1);
  EXPECT_EQ(grid.m, 2);
  EXPECT_EQ(grid.normals.row(2), Eigen::RowVector3d(0, 1, 0));  // of unit length
  EXPECT_EQ(grid.lambda[5], 2.0);
  EXPECT_EQ(guidance->corners->alongU, Eigen::Vector3d::UnitX());
  EXPECT_FALSE(energy::validate(*guidance).has_value());
}

TEST(GuideJson, ReadsASplineOfNormals) {
  const auto guidance = read(R"({"field": {"degree": [1, 2], "knots": [[0,0,1,1],[0,0,0,1,1,1]],
      "normals": [[0,0,1],[0,0,2],[0,3,0],[1,0,0],[0,0,0],[0,1,0]]}})");
  ASSERT_TRUE(guidance.has_value());
  EXPECT_EQ(guidance->continuous->normals.evaluate(0, 1), Eigen::Vector3d(0, 3, 0));
  EXPECT_FALSE(guidance->continuous->reference.has_value());
}

TEST(GuideJson, SaysWhatIsWrong) {
  EXPECT_THAT(whyNot("{}"), HasSubstr("guide.json: it has no list called \"normals\""));
  EXPECT_THAT(whyNot(R"({"field": {"n": 1, "m": 1, "normals": [[0,0,1]]}})"),
              HasSubstr("its field needs 4 normals and has 1"));
  EXPECT_THAT(whyNot(R"({"field": {"n": 0, "m": 1, "normals": []}})"), HasSubstr("1 or more"));
  EXPECT_THAT(whyNot(R"({"field": {"n": 1, "m": 1, "weights": [1],
                         "normals": [[0,0,1],[0,0,1],[0,0,1],[0,0,1]]}})"),
              HasSubstr("needs 4 weights and has 1"));
  EXPECT_THAT(whyNot(R"({"field": {"n": 1, "m": 1, "weights": [1,1,-1,1],
                         "normals": [[0,0,1],[0,0,1],[0,0,1],[0,0,1]]}})"),
              HasSubstr("not zero or more"));
  EXPECT_THAT(whyNot(R"({"field": {"n": 1, "m": 1,
                         "normals": [[0,0,1],[0,0,0],[0,0,1],[0,0,1]]}})"),
              HasSubstr("normal 2 of its field is zero"));
  EXPECT_THAT(whyNot(R"({"field": {"degree": [0, 1], "normals": []}})"), HasSubstr("degree"));
  EXPECT_THAT(whyNot(R"({"field": {"degree": [1, 1], "knots": [[0,1],[0,0,1,1]], "normals": []}})"),
              HasSubstr("knots"));
  EXPECT_THAT(whyNot(R"({"field": {"m": 1}})"), HasSubstr("its field is wrong"));
  EXPECT_THAT(whyNot(R"({"field": {"n": 1, "m": 1, "corners": [[0,0,0]],
                         "normals": [[0,0,1],[0,0,1],[0,0,1],[0,0,1]]}})"),
              HasSubstr("three \"corners\""));
}

}  // namespace
}  // namespace fairing::text
