// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/through.h"

#include <filesystem>
#include <fstream>

#include "cli/parse.h"
#include "occt/inner_constraints.h"
#include "occt/shape_file.h"

namespace fairing::cli {
namespace {

bool isShapeFile(const std::string& name) {
  const std::string extension = std::filesystem::path(name).extension().string();
  return extension == ".brep" || extension == ".brp" || extension == ".step" || extension == ".stp";
}

Result<std::vector<InnerConstraint>> readPoints(const std::string& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    return fail({.code = ErrorCode::FileUnreadable, .detail = path});
  std::vector<InnerConstraint> points;
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const auto point = parseVector(line);
    if (!point) return fail(unknown("--through in " + path, line));
    points.push_back(occt::throughPoint(*point));
  }
  if (points.empty()) return fail({.code = ErrorCode::FileNotAShape, .detail = path});
  return points;
}

}  // namespace

Result<std::vector<InnerConstraint>> readThrough(const std::string& word) {
  if (const auto point = parseVector(word)) return std::vector{occt::throughPoint(*point)};
  if (!isShapeFile(word)) return readPoints(word);
  const auto shape = occt::readShape(word);
  if (!shape) return fail(shape.error());
  return occt::throughShape(*shape);
}

}  // namespace fairing::cli
