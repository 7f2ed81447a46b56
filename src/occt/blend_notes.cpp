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

/// The faces beside the sides [from, to).
std::set<int> facesBeside(const boundary::ChainPair& pair, std::size_t from, std::size_t to) {
  std::set<int> faces;
  for (std::size_t k = from; k < to; ++k)
    if (pair.sides.sides[k].face > 0) faces.insert(pair.sides.sides[k].face);
  return faces;
}

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

/// The faces of both sides cut through each other, or a side starts inside the other one's solid.
void addOverlap(const ShapeIndex& index,
                const boundary::ChainPair& pair,
                const std::vector<std::pair<int, TriangleTree>>& trees,
                const std::set<int>& first,
                const std::set<int>& second,
                std::vector<Note>& notes) {
  std::vector<Vector3d> crossings;
  for (const auto& [a, treeA] : trees)
    for (const auto& [b, treeB] : trees) {
      if (a == b || !first.contains(a) || !second.contains(b)) continue;
      for (const Vector3d& p : treeA.crossings(treeB, Touches::DoNotCount)) crossings.push_back(p);
    }
  if (!crossings.empty()) return addNote(notes, NoteCode::BasesOverlap, crossings);
  const auto pointOf = [&](std::size_t side) {
    return pair.sides.sides[side].ribbon.curve(0.5).point;
  };
  const Vector3d a = pointOf(0), b = pointOf(pair.secondStart());
  if (isInside(index, second, a))
    addNote(notes, NoteCode::BasesOverlap, {a});
  else if (isInside(index, first, b))
    addNote(notes, NoteCode::BasesOverlap, {b});
}

}  // namespace

std::vector<Note> blendNotes(const ShapeIndex& index,
                             const boundary::ChainPair& pair,
                             const std::vector<spline::BsplineSurface>& patches) {
  std::vector<Note> notes;
  addCreases(pair.sides, notes);
  if (const auto fold = analysis::findFold(patches))
    notes.push_back({NoteCode::StripFolds, 0, fold->where, fold->share, 0});
  const TriangleTree strip(analysis::meshOf(patches));
  addNote(notes, NoteCode::CutsItself, strip.ownCrossings());
  const auto first = facesBeside(pair, 0, pair.firstCount);
  const auto second = facesBeside(pair, pair.secondStart(), pair.secondEnd());
  std::set<int> all = first;
  all.insert(second.begin(), second.end());
  std::vector<std::pair<int, TriangleTree>> trees;
  for (const int face : all)
    trees.emplace_back(face, meshOf(index.face(face), kDeflection * pair.sides.diagonal));
  const NearSides nearSides(pair.sides);
  for (const auto& [face, tree] : trees)
    addNote(
        notes, NoteCode::CutsFace, nearSides.farFrom(strip.crossings(tree, Touches::Count)), face);
  addOverlap(index, pair, trees, first, second, notes);
  return notes;
}

}  // namespace fairing::occt
