// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/mesh_reference.h"

#include <BRep_Builder.hxx>
#include <BVH_Distance.hxx>
#include <BVH_Tools.hxx>
#include <BVH_Triangulation.hxx>
#include <Eigen/Geometry>
#include <RWStl.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "occt/from_occt.h"
#include "occt/triangles_of.h"

namespace fairing::occt {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<int, 3>;  // corners from 0
using Tree = BVH_Triangulation<double, 3>;

// A coordinate on a triangle this small puts a foot on its edge; a point is above its foot unless
// it is this far aside, as a share of its distance.
constexpr double kOnEdge = 1e-9, kAside = 0.01;

using Edge = std::pair<int, int>;  // in the direction in which a triangle has it

std::map<Edge, int> edgesOf(const std::vector<Triangle>& triangles) {
  std::map<Edge, int> edges;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  return edges;
}

// Two triangles that share an edge run through it in opposite directions.
std::optional<Error> flipped(const Poly_Triangulation& mesh) {
  Error error{.code = ErrorCode::MeshFlipped};
  for (const auto& [edge, uses] : edgesOf(trianglesOf(mesh))) {
    if (uses < 2) continue;
    if (error.value == 0.0) error.where = fromOcct(mesh.Node(edge.first + 1));
    error.value += 1.0;
  }
  if (error.value == 0.0) return std::nullopt;
  return error;
}

Result<TopoDS_Shape> faceOf(const Handle(Poly_Triangulation) & mesh) {
  if (mesh.IsNull() || mesh->NbTriangles() == 0) return fail({.code = ErrorCode::MeshInvalid});
  if (const auto error = flipped(*mesh)) return fail(*error);
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, mesh);
  return face;
}

BVH_Vec3d vectorOf(const Vector3d& p) {
  return BVH_Vec3d(p.x(), p.y(), p.z());
}
Vector3d vectorOf(const BVH_Vec3d& p) {
  return {p.x(), p.y(), p.z()};
}

// The shares of a segment's ends in its point nearest to p.
Eigen::Vector2d sharesOn(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return {1.0 - t, t};
}

// The shares of a triangle's corners in its point nearest to p: below p, or on an edge.
Vector3d sharesOn(const Vector3d& p, const std::array<Vector3d, 3>& t) {
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  Vector3d shares;
  for (std::size_t k = 0; k < 3; ++k)
    shares[Eigen::Index(k)] =
        (t[(k + 1) % 3] - p).cross(t[(k + 2) % 3] - p).dot(normal) / normal.squaredNorm();
  if (shares.minCoeff() >= 0.0) return shares;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Eigen::Vector2d onEdge = sharesOn(p, t[k], t[next]);
    const double distance = (onEdge[0] * t[k] + onEdge[1] * t[next] - p).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    shares.setZero();
    shares[Eigen::Index(k)] = onEdge[0];
    shares[Eigen::Index(next)] = onEdge[1];
  }
  return shares;
}

// The triangle nearest to a point.
class Nearest : public BVH_Distance<double, 3, BVH_Vec3d, Tree> {
 public:
  Nearest(const Vector3d& point, Tree& tree) {
    SetObject(vectorOf(point));
    SetBVHSet(&tree);
    ComputeDistance();
  }
  Standard_Boolean RejectNode(const BVH_Vec3d& low,
                              const BVH_Vec3d& high,
                              Standard_Real& metric) const override {
    metric = BVH_Tools<double, 3>::PointBoxSquareDistance(myObject, low, high);
    return RejectMetric(metric);
  }
  Standard_Boolean Accept(const Standard_Integer index, const Standard_Real&) override {
    const BVH_Vec4i t = myBVHSet->Elements[static_cast<std::size_t>(index)];
    const auto corner = [&](int k) {
      return vectorOf(myBVHSet->Vertices[static_cast<std::size_t>(k)]);
    };
    const std::array<Vector3d, 3> at{corner(t.x()), corner(t.y()), corner(t.z())};
    const Vector3d point = vectorOf(myObject), shares = sharesOn(point, at);
    const Vector3d foot = shares[0] * at[0] + shares[1] * at[1] + shares[2] * at[2];
    const double distance = (foot - point).squaredNorm();
    if (!(distance < myDistance)) return Standard_False;
    myDistance = distance;
    foot_ = foot;
    shares_ = shares;
    corners_ = {t.x(), t.y(), t.z()};
    return Standard_True;
  }
  [[nodiscard]] const Vector3d& foot() const { return foot_; }
  /// Of the corners in the foot.
  [[nodiscard]] const Vector3d& shares() const { return shares_; }
  [[nodiscard]] const Triangle& corners() const { return corners_; }

 private:
  Vector3d foot_ = Vector3d::Zero(), shares_ = Vector3d::Zero();
  Triangle corners_{};
};

class Mesh {
 public:
  explicit Mesh(const Poly_Triangulation& mesh) {
    for (int k = 1; k <= mesh.NbNodes(); ++k) {
      points_.push_back(fromOcct(mesh.Node(k)));
      tree_.Vertices.push_back(vectorOf(points_.back()));
    }
    normals_.assign(points_.size(), Vector3d::Zero());
    const std::vector<Triangle> triangles = trianglesOf(mesh);
    for (const Triangle& t : triangles) {
      tree_.Elements.emplace_back(t[0], t[1], t[2], 0);
      const Vector3d normal = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
      for (const int corner : t) normals_[static_cast<std::size_t>(corner)] += normal;
    }
    const std::map<Edge, int> edges = edgesOf(triangles);
    for (const auto& [edge, uses] : edges) {
      if (edges.count({edge.second, edge.first}) > 0) continue;
      border_.insert(edge);
      rim_.insert({edge.first, edge.second});
    }
    tree_.MarkDirty();
    tree_.BVH();
  }

  [[nodiscard]] energy::GuidanceSample near(const Vector3d& point) const {
    const Nearest found(point, tree_);
    const Triangle& t = found.corners();
    const Vector3d& shares = found.shares();
    Vector3d normal = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      normal += shares[k] *
                normals_[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])].normalized();
    const Vector3d away = point - found.foot();
    const Vector3d aside = away - away.dot(normal.normalized()) * normal.normalized();
    const bool beside = isOnBorder(t, shares) && aside.norm() > kAside * away.norm();
    const double weight = beside || !(normal.norm() > 0.0) ? 0.0 : 1.0;
    return {normal.normalized(), found.foot(), weight, weight};
  }

 private:
  [[nodiscard]] const Vector3d& at(int corner) const {
    return points_[static_cast<std::size_t>(corner)];
  }
  [[nodiscard]] bool isOnBorder(const Triangle& t, const Vector3d& shares) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<Eigen::Index>(k);
      if (shares[corner] > 1.0 - kOnEdge && rim_.count(t[k]) > 0) return true;
      if (shares[corner] < kOnEdge && border_.count({t[(k + 1) % 3], t[(k + 2) % 3]}) > 0)
        return true;
    }
    return false;
  }

  std::vector<Vector3d> points_, normals_;
  std::set<Edge> border_;  // edges with a triangle on one side only
  std::set<int> rim_;      // their ends
  mutable Tree tree_;      // asked only, once it is built
};

}  // namespace

Result<TopoDS_Shape> meshFace(
    const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>& points,
    const Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>& triangles) {
  const auto count = static_cast<int>(points.rows());
  const bool isWhole = triangles.size() > 0 && points.allFinite() && triangles.minCoeff() >= 0 &&
                       triangles.maxCoeff() < count;
  if (!isWhole) return fail({.code = ErrorCode::MeshInvalid});
  const Handle(Poly_Triangulation) mesh =
      new Poly_Triangulation(count, static_cast<int>(triangles.rows()), Standard_False);
  for (int k = 0; k < count; ++k)
    mesh->SetNode(k + 1, gp_Pnt(points(k, 0), points(k, 1), points(k, 2)));
  for (int k = 0; k < triangles.rows(); ++k)
    mesh->SetTriangle(k + 1,
                      Poly_Triangle(triangles(k, 0) + 1, triangles(k, 1) + 1, triangles(k, 2) + 1));
  return faceOf(mesh);
}

Result<TopoDS_Shape> readMesh(const std::string& path) {
  const Handle(Poly_Triangulation) mesh = RWStl::ReadFile(path.c_str());
  if (mesh.IsNull()) return fail({.code = ErrorCode::FileUnreadable, .detail = path});
  return faceOf(mesh);
}

std::function<energy::GuidanceSample(const Vector3d&)> referenceOnMesh(
    const Handle(Poly_Triangulation) & mesh) {
  return [found = std::make_shared<const Mesh>(*mesh)](const Vector3d& point) {
    return found->near(point);
  };
}

}  // namespace fairing::occt
