// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/check_shape.h"

#include <BRepCheck.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <sstream>

namespace fairing::occt {
namespace {

std::string firstStatus(const BRepCheck_ListOfStatus& statuses) {
  for (const BRepCheck_Status status : statuses) {
    if (status == BRepCheck_NoError) continue;
    std::ostringstream words;
    BRepCheck::Print(status, words);
    std::string text = words.str();
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
  }
  return {};
}

}  // namespace

std::optional<Error> checkShape(const TopoDS_Shape& shape) {
  const BRepCheck_Analyzer check(shape);
  if (check.IsValid()) return std::nullopt;
  Error error{.code = ErrorCode::ResultInvalid};
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, parts);
  for (int i = 1; i <= parts.Extent() && error.detail.empty(); ++i) {
    const Handle(BRepCheck_Result)& result = check.Result(parts(i));
    if (result.IsNull()) continue;
    error.detail = firstStatus(result->Status());
    for (result->InitContextIterator(); result->MoreShapeInContext() && error.detail.empty();
         result->NextShapeInContext()) {
      error.detail = firstStatus(result->StatusOnShape());
    }
  }
  return error;
}

}  // namespace fairing::occt
