// SPDX-License-Identifier: LGPL-2.1-or-later
#include "text/guide_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/spline/bspline_basis.h"

namespace fairing::text {
namespace {

using nlohmann::json;
using spline::KnotVector;

/// What is wrong with a guide, as the end of a sentence.
class Invalid : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void check(bool holds, const std::string& why) {
  if (!holds) throw Invalid(why);
}

bool isWeight(double value) {
  return std::isfinite(value) && value >= 0.0;
}

Eigen::Vector3d vectorFrom(const json& entry) {
  const auto v = entry.get<std::array<double, 3>>();
  return {v[0], v[1], v[2]};
}

energy::NormalHandle handleFrom(const json& entry, std::size_t number) {
  const std::string which = fmt::format("normal {} is wrong, ", number);
  try {
    energy::NormalHandle handle{.point = vectorFrom(entry.at("point")),
                                .normal = vectorFrom(entry.at("normal")),
                                .weight = entry.value("weight", 1.0),
                                .radius = entry.at("radius").get<double>()};
    check(handle.point.allFinite() && handle.normal.allFinite(),
          which + "a coordinate is not finite");
    check(handle.normal.norm() > 0.0, which + "its normal is zero");
    check(isWeight(handle.weight), which + "its weight must be zero or more");
    check(std::isfinite(handle.radius) && handle.radius > 0.0,
          which + "its radius must be above zero");
    handle.normal.normalize();
    return handle;
  } catch (const json::exception&) {
    throw Invalid(which +
                  "it needs \"point\" and \"normal\" of three numbers each and a \"radius\"");
  }
}

std::vector<Eigen::Vector3d> vectorsFrom(const json& list) {
  std::vector<Eigen::Vector3d> vectors;
  for (const json& entry : list) vectors.push_back(vectorFrom(entry));
  return vectors;
}

energy::NormalCurve curveFrom(const json& entry, std::size_t number) {
  const std::string which = fmt::format("curve {} is wrong, ", number);
  try {
    energy::NormalCurve curve{.points = vectorsFrom(entry.at("points")),
                              .normals = vectorsFrom(entry.at("normals")),
                              .weight = entry.value("weight", 1.0),
                              .radius = entry.at("radius").get<double>()};
    if (curve.normals.size() == 1) curve.normals.resize(curve.points.size(), curve.normals[0]);
    check(!curve.points.empty() && curve.normals.size() == curve.points.size(),
          which + "it needs a normal for each of its points, or one for all");
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      check(curve.points[k].allFinite() && curve.normals[k].allFinite(),
            which + "a coordinate is not finite");
      check(curve.normals[k].norm() > 0.0, which + "a normal of it is zero");
    }
    check(isWeight(curve.weight), which + "its weight must be zero or more");
    check(std::isfinite(curve.radius) && curve.radius > 0.0,
          which + "its radius must be above zero");
    return curve;
  } catch (const json::exception&) {
    throw Invalid(which +
                  "it needs \"points\" and \"normals\" of three numbers each and a "
                  "\"radius\"");
  }
}

/// The field's normals, one a row; `count` of them.
spline::Poles normalsFrom(const json& field, Eigen::Index count) {
  const json& list = field.at("normals");
  check(list.is_array() && Eigen::Index(list.size()) == count,
        fmt::format("its field needs {} normals and has {}", count, list.size()));
  spline::Poles normals(count, 3);
  for (Eigen::Index k = 0; k < count; ++k)
    normals.row(k) = vectorFrom(list[static_cast<std::size_t>(k)]).transpose();
  check(normals.allFinite(), "a normal of its field is not finite");
  return normals;
}

energy::DiscreteGuidance gridFrom(const json& field) {
  energy::DiscreteGuidance grid;
  grid.n = field.at("n").get<int>();
  grid.m = field.at("m").get<int>();
  check(grid.n >= 1 && grid.m >= 1, "its field needs \"n\" and \"m\" of 1 or more");
  const Eigen::Index count = Eigen::Index(grid.n + 1) * (grid.m + 1);
  grid.normals = normalsFrom(field, count);
  grid.points = spline::Poles::Zero(count, 3);
  grid.gamma = Eigen::VectorXd::Zero(count);
  const auto weights =
      field.value("weights", std::vector<double>(static_cast<std::size_t>(count), 1.0));
  check(Eigen::Index(weights.size()) == count,
        fmt::format("its field needs {} weights and has {}", count, weights.size()));
  check(std::all_of(weights.begin(), weights.end(), isWeight),
        "a weight of its field is not zero or more");
  grid.lambda = Eigen::Map<const Eigen::VectorXd>(weights.data(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    if (grid.lambda[k] == 0.0) continue;
    check(grid.normals.row(k).norm() > 0.0,
          fmt::format("normal {} of its field is zero, give it a direction or no weight", k + 1));
    grid.normals.row(k).normalize();
  }
  return grid;
}

KnotVector knotsFrom(const json& field, std::size_t direction) {
  const int degree = field.at("degree").at(direction).get<int>();
  check(degree >= 1 && degree <= spline::kMaxDegree,
        fmt::format("the degree of its field must be from 1 to {}", spline::kMaxDegree));
  if (!field.contains("knots")) return KnotVector::bezier(degree);
  const auto knots = field.at("knots").at(direction).get<std::vector<double>>();
  const auto ends = static_cast<std::size_t>(degree) + 1;
  check(knots.size() >= 2 * ends && std::is_sorted(knots.begin(), knots.end()) &&
            knots.front() == knots[ends - 1] && knots.back() == knots[knots.size() - ends] &&
            knots.front() < knots.back(),
        "the knots of its field must not fall, and the first and the last must be repeated "
        "degree + 1 times");
  return {degree, knots};
}

energy::ContinuousGuidance splineFrom(const json& field) {
  const KnotVector u = knotsFrom(field, 0), v = knotsFrom(field, 1);
  return {{u, v, normalsFrom(field, Eigen::Index(u.poleCount()) * v.poleCount())}};
}

void addField(const json& field, energy::Guidance& guidance) {
  try {
    if (field.contains("degree")) {
      guidance.continuous = splineFrom(field);
    } else {
      guidance.discrete = gridFrom(field);
    }
    if (!field.contains("corners")) return;
    const json& corners = field.at("corners");
    check(corners.is_array() && corners.size() == 3, "its field needs three \"corners\"");
    guidance.corners = energy::FieldCorners{
        vectorFrom(corners[0]), vectorFrom(corners[1]), vectorFrom(corners[2])};
  } catch (const json::exception&) {
    throw Invalid(
        "its field is wrong, it needs \"n\" and \"m\" or a \"degree\" of two numbers, and "
        "\"normals\" of three numbers each");
  }
}

energy::Guidance parsed(const json& guide) {
  const bool hasField = guide.is_object() && guide.contains("field");
  const bool hasHandles = guide.is_array() ? !guide.empty() : guide.contains("normals");
  const bool hasCurves = guide.is_object() && guide.contains("curves");
  check(hasField || hasHandles || hasCurves,
        "it has no list called \"normals\" or \"curves\" and no \"field\"");
  energy::Guidance guidance;
  if (hasHandles) {
    const json& handles = guide.is_array() ? guide : guide["normals"];
    check(handles.is_array(), "it has no list called \"normals\"");
    for (const json& entry : handles)
      guidance.handles.push_back(handleFrom(entry, guidance.handles.size() + 1));
  }
  if (hasCurves) {
    check(guide["curves"].is_array(), "its \"curves\" are no list");
    for (const json& entry : guide["curves"])
      guidance.curves.push_back(curveFrom(entry, guidance.curves.size() + 1));
  }
  if (hasField) addField(guide["field"], guidance);
  return guidance;
}

}  // namespace

Result<energy::Guidance> guidanceFrom(const json& guide, const std::string& source) {
  try {
    return parsed(guide);
  } catch (const Invalid& why) {
    return fail({.code = ErrorCode::GuideInvalid, .detail = source + ": " + why.what()});
  }
}

}  // namespace fairing::text
