// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/blend_notes.h"

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>
#include <set>

#include "core/analysis/find_fold.h"
#include "core/analysis/patch_mesh.h"
#include "occt/from_occt.h"

namespace fairing::occt {
namespace {

using analysis::Note;
using analysis::NoteCode;
using analysis::Touches;
using analysis::TriangleMesh;
using analysis::TriangleTree;
using Eigen::Vector3d;

constexpr double kDeflection = 2e-3, kNearEdges = 1e-2;  // of the diagonal
constexpr double kMeshAngle = 0.3;                       // radians
constexpr int kSamplesAlong = 64;

/// A copy is meshed: the user's shape stays as it is.
TriangleMesh meshOf(const TopoDS_Face& face, double deflection) {
  BRepBuilderAPI_Copy copy(face, Standard_False, Standard_False);
  const BRepMesh_IncrementalMesh mesher(copy.Shape(), deflection, Standard_False, kMeshAngle);
  TopLoc_Location place;
  const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(copy.Shape()), place);
  TriangleMesh result;
  if (mesh.IsNull()) return result;
  for (int k = 1; k <= mesh->NbNodes(); ++k)
    result.points.push_back(fromOcct(mesh->Node(k).Transformed(place.Transformation())));
  for (int k = 1; k <= mesh->NbTriangles(); ++k) {
    int a = 0, b = 0, c = 0;
    mesh->Triangle(k).Get(a, b, c);
    result.triangles.push_back({a - 1, b - 1, c - 1});
  }
  return result;
}

/// Points of all sides, close enough together to tell what lies next to them.
class NearSides {
 public:
  NearSides(const boundary::BoundaryLoop& loop) : limit_(kNearEdges * loop.diagonal) {
    for (const boundary::BoundarySide& side : loop.sides)
      for (int k = 0; k <= kSamplesAlong; ++k)
        points_.push_back(side.ribbon.curve(double(k) / kSamplesAlong).point);
    for (std::size_t k = 0; k < loop.sides.size(); ++k)
      spacing_ = std::max(spacing_, loop.sides[k].length / kSamplesAlong);
  }
  [[nodiscard]] std::vector<Vector3d> farFrom(std::vector<Vector3d> points) const {
    std::erase_if(points, [&](const Vector3d& p) {
      return std::any_of(points_.begin(), points_.end(), [&](const Vector3d& q) {
        return (p - q).norm() <= limit_ + 0.5 * spacing_;
      });
    });
    return points;
  }

 private:
  double limit_, spacing_ = 0.0;
  std::vector<Vector3d> points_;
};

/// A note for every corner the blend has a crease from.
void addCreases(const boundary::BoundaryLoop& sides, std::vector<Note>& notes) {
  for (std::size_t k = 0; k < sides.sides.size(); ++k)
    if (const boundary::Corner& corner = sides.corners[k]; corner.crease && !corner.apart)
      notes.push_back({NoteCode::StripCreased,
                       sides.sides[k].edge,
                       corner.point,
                       corner.normalsAgree(1.0) ? 0.0 : corner.normalMismatch});
}

void addNote(std::vector<Note>& notes,
             NoteCode code,
             const std::vector<Vector3d>& crossings,
             int face = 0) {
  if (const auto size = analysis::sizeOf(crossings))
    notes.push_back({code, 0, size->where, size->extent, face});
}

/// The solid a face belongs to, if any.
std::optional<TopoDS_Shape> solidOf(const TopoDS_Shape& shape, const TopoDS_Face& face) {
  for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(solids.Current(), TopAbs_FACE, faces);
    if (faces.Contains(face)) return solids.Current();
  }
  return std::nullopt;
}

/// Whether a point lies inside the solid one of the faces belongs to.
bool isInside(const ShapeIndex& index, const std::set<int>& faces, const Vector3d& point) {
  for (const int face : faces) {
    const auto solid = solidOf(index.shape(), index.face(face));
    if (!solid) continue;
    const BRepClass3d_SolidClassifier inside(*solid, toPoint(point), 1e-7);
    if (inside.State() == TopAbs_IN) return true;
  }
  return false;
}

/// The face trees of one chain cut through those of another, or one starts inside the other one's
/// solid.
class Overlap {
 public:
  Overlap(const ShapeIndex& index,
          const boundary::BoundaryLoop& sides,
          const std::vector<boundary::SideRange>& chains)
      : index_(index), sides_(sides), chains_(chains) {
    const double deflection = kDeflection * sides.diagonal;
    for (const boundary::SideRange& chain : chains_) {
      faces_.push_back(sides.facesBeside(chain));
      for (const int face : faces_.back())
        if (!trees_.contains(face)) trees_.emplace(face, meshOf(index.face(face), deflection));
    }
  }
  [[nodiscard]] const std::map<int, TriangleTree>& trees() const { return trees_; }

  void addTo(std::vector<Note>& notes) const {
    for (std::size_t a = 0; a < chains_.size(); ++a)
      for (std::size_t b = a + 1; b < chains_.size(); ++b)
        addNote(notes, NoteCode::BasesOverlap, between(a, b));
  }

 private:
  [[nodiscard]] std::vector<Vector3d> between(std::size_t a, std::size_t b) const {
    std::vector<Vector3d> crossings;
    for (const int one : faces_[a])
      for (const int other : faces_[b]) {
        if (one == other) continue;
        for (const Vector3d& p : trees_.at(one).crossings(trees_.at(other), Touches::DoNotCount))
          crossings.push_back(p);
      }
    if (!crossings.empty()) return crossings;
    const Vector3d p = startOf(a), q = startOf(b);
    if (isInside(index_, faces_[b], p)) return {p};
    if (isInside(index_, faces_[a], q)) return {q};
    return {};
  }
  [[nodiscard]] Vector3d startOf(std::size_t chain) const {
    return sides_.sides[chains_[chain].first].ribbon.curve(0.5).point;
  }

  const ShapeIndex& index_;
  const boundary::BoundaryLoop& sides_;
  const std::vector<boundary::SideRange>& chains_;
  std::vector<std::set<int>> faces_;  // beside every chain
  std::map<int, TriangleTree> trees_;
};

}  // namespace

std::vector<Note> blendNotes(const ShapeIndex& index,
                             const boundary::BoundaryLoop& sides,
                             const std::vector<boundary::SideRange>& chains,
                             const std::vector<spline::BsplineSurface>& patches) {
  std::vector<Note> notes;
  addCreases(sides, notes);
  if (const auto fold = analysis::findFold(patches))
    notes.push_back({NoteCode::StripFolds, 0, fold->where, fold->share, 0});
  const TriangleTree blend(analysis::meshOf(patches));
  addNote(notes, NoteCode::CutsItself, blend.ownCrossings());
  const Overlap overlap(index, sides, chains);
  const NearSides nearSides(sides);
  for (const auto& [face, tree] : overlap.trees())
    addNote(
        notes, NoteCode::CutsFace, nearSides.farFrom(blend.crossings(tree, Touches::Count)), face);
  overlap.addTo(notes);
  return notes;
}

}  // namespace fairing::occt
