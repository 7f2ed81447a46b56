// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/error_text.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>

namespace fairing::text {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Error> oneOfEach() {
  std::vector<Error> errors;
  for (int code = 0; code <= int(ErrorCode::Foreign); ++code) {
    errors.push_back({.code = ErrorCode(code),
                      .edge = 17,
                      .face = 23,
                      .where = Eigen::Vector3d(1.5, -2.0, 0.0),
                      .value = 3.0,
                      .detail = "part.brep"});
  }
  return errors;
}

TEST(ErrorText, GivesEveryErrorOneSentenceOfItsOwn) {
  std::set<std::string> all;
  for (const Error& error : oneOfEach()) {
    const std::string text = sentence(error);
    EXPECT_THAT(text, EndsWith(".")) << int(error.code);
    EXPECT_THAT(text, Not(HasSubstr("\n"))) << int(error.code);
    EXPECT_NE(text, "Something went wrong.") << int(error.code);
    EXPECT_GT(text.size(), 8u);
    EXPECT_TRUE(all.insert(text).second) << "said twice: " << text;
  }
}

TEST(ErrorText, NamesEdgeAndPlaceWhereTheyMatter) {
  for (const Error& error : oneOfEach()) {
    switch (error.code) {
      case ErrorCode::LoopNotClosed:
      case ErrorCode::LoopSelfTouching:
      case ErrorCode::LoopBranches:
      case ErrorCode::EdgeDegenerate:
      case ErrorCode::CurveNotFitted:
      case ErrorCode::SupportNormalSingular:
      case ErrorCode::LoopCrossesItself:
      case ErrorCode::DirectionAlongEdge:
      case ErrorCode::EdgeOffPlane:
      case ErrorCode::SetbackCurveBroken:
      case ErrorCode::SetbackCurveOff:
      case ErrorCode::SetbackCurveShort:
      case ErrorCode::EndJoinsNothing:
      case ErrorCode::EndTwice:
      case ErrorCode::EndTurns:
      case ErrorCode::EndAlongSide:
      case ErrorCode::EndAgainstSide:
        EXPECT_THAT(sentence(error), HasSubstr("dge 17"));
        EXPECT_THAT(sentence(error), HasSubstr("(1.5, -2, 0)"));
        break;
      case ErrorCode::EdgeOutOfRange:
      case ErrorCode::EdgeNotFree:
      case ErrorCode::EdgeWithManyFaces:
      case ErrorCode::EdgeWithoutFace:
      case ErrorCode::SeveralLoops:
      case ErrorCode::SetbackCurveUnlike:
      case ErrorCode::SetbackCurveBeside:
      case ErrorCode::EndsUnused:
      case ErrorCode::EndOnSide:
        EXPECT_THAT(sentence(error), HasSubstr("dge 17"));
        break;
      default:
        break;
    }
  }
}

TEST(ErrorText, GivesGapsTheirUnit) {
  EXPECT_EQ(sentence({.code = ErrorCode::LoopNotClosed, .edge = 4, .value = 0.25}),
            "The loop does not close: a gap of 0.25 mm at the end of edge 4.");
}

TEST(ErrorText, ListsTheEdgesThatStayFreeWithTheirGaps) {
  EXPECT_EQ(
      sentence({.code = ErrorCode::SewingOpen,
                .edge = 4,
                .value = 2,
                .detail = "edge 4: 0.25 mm, edge 9: 0.1 mm"}),
      "The new faces could not be sewn to 2 edges, these gaps stay open: edge 4: 0.25 mm, edge 9: "
      "0.1 mm.");
}

TEST(ErrorText, DoesNotPrintNanAsANumber) {
  EXPECT_EQ(sentence({.code = ErrorCode::WeightNegative,
                      .value = std::numeric_limits<double>::quiet_NaN(),
                      .detail = "gamma"}),
            "The weight gamma must be zero or more, not NaN.");
}

}  // namespace
}  // namespace fairing::text
