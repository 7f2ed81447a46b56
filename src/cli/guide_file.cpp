// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/guide_file.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "occt/mesh_reference.h"
#include "occt/reference.h"
#include "occt/shape_file.h"
#include "text/guide_json.h"

namespace fairing::cli {
namespace {

Result<energy::Guidance> readGuide(const std::string& path) {
  std::ifstream file(path);
  if (!file) return fail({.code = ErrorCode::FileUnreadable, .detail = path});
  const auto guide = nlohmann::json::parse(file, nullptr, false);
  if (guide.is_discarded())
    return fail({.code = ErrorCode::GuideInvalid, .detail = path + ": it is not JSON"});
  return text::guidanceFrom(guide, path);
}

bool isMesh(const std::string& path) {
  const std::string end = std::filesystem::path(path).extension().string();
  return end == ".stl" || end == ".STL";
}

}  // namespace

Result<energy::Guidance> readGuidance(double lambda,
                                      double gamma,
                                      const std::string& guide,
                                      const std::string& reference) {
  energy::Guidance guidance;
  if (!guide.empty()) {
    auto read = readGuide(guide);
    if (!read) return read;
    guidance = std::move(*read);
  }
  guidance.lambda = lambda;
  guidance.gamma = gamma;
  if (!reference.empty()) {
    const auto faces = isMesh(reference) ? occt::readMesh(reference) : occt::readShape(reference);
    if (!faces) return fail(faces.error());
    auto nearest = occt::referenceOn(*faces);
    if (!nearest) return fail(nearest.error());
    guidance.reference = std::move(*nearest);
  }
  return guidance;
}

}  // namespace fairing::cli
