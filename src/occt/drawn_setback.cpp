// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/drawn_setback.h"

#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <deque>
#include <limits>
#include <optional>

#include "occt/border_candidates.h"
#include "occt/border_graph.h"
#include "occt/coincidence.h"
#include "occt/curve_shadow.h"
#include "occt/face_projector.h"

namespace fairing::occt {
namespace {

using analysis::Note;
using analysis::NoteCode;
using Eigen::Vector3d;

constexpr double kFarthest = 0.05;  // of the pair's diagonal: off a face
constexpr double kLongest = 0.05;   // of the curve's length: from its end to the border

/// The drawn edges as one curve.
struct DrawnCurve {
  std::vector<Candidate> edges;  // their ends joined
  std::vector<Vector3d> nodes;
  std::map<int, int> meeting;  // edge ends by node
  double length = 0.0;

  [[nodiscard]] bool isClosed() const {
    return std::all_of(meeting.begin(), meeting.end(), [](const auto& m) { return m.second == 2; });
  }
  [[nodiscard]] const Vector3d& endOf(const Candidate& edge, std::size_t end) const {
    return end == 0 ? edge.samples.front() : edge.samples.back();
  }
  /// How far the ends that are one lie from it, mm.
  [[nodiscard]] double spread(int node) const {
    double largest = 0.0;
    for (const Candidate& edge : edges)
      for (const std::size_t end : {0U, 1U})
        if (edge.ends[end] == node)
          largest = std::max(largest, (endOf(edge, end) - nodes[std::size_t(node)]).norm());
    return largest;
  }
};

/// SetbackCurveBroken where more than two edges meet or not all connect.
std::optional<Error> brokenAt(const DrawnCurve& curve) {
  const auto broken = [&](const Candidate& edge, std::size_t end) {
    return Error{
        .code = ErrorCode::SetbackCurveBroken, .edge = edge.edge, .where = curve.endOf(edge, end)};
  };
  for (const Candidate& edge : curve.edges)
    for (const std::size_t end : {0U, 1U})
      if (curve.meeting.at(edge.ends[end]) > 2) return broken(edge, end);
  std::vector<const Candidate*> left;
  for (const Candidate& edge : curve.edges) left.push_back(&edge);
  std::vector<const Candidate*> pending{left.front()};
  left.erase(left.begin());
  while (!pending.empty()) {
    const Candidate& edge = *pending.back();
    pending.pop_back();
    const auto apart = std::partition(left.begin(), left.end(), [&](const Candidate* other) {
      return std::none_of(other->ends.begin(), other->ends.end(), [&](int node) {
        return node == edge.ends[0] || node == edge.ends[1];
      });
    });
    pending.insert(pending.end(), apart, left.end());
    left.erase(apart, left.end());
  }
  if (left.empty()) return std::nullopt;
  return broken(
      **std::min_element(
          left.begin(), left.end(), [](const auto* a, const auto* b) { return a->edge < b->edge; }),
      0);
}

Result<DrawnCurve> curveOf(const ShapeIndex& index, std::vector<int> drawn) {
  if (const auto wrong = wrongEdge(index, drawn)) return fail(*wrong);
  std::sort(drawn.begin(), drawn.end());
  DrawnCurve curve;
  for (const int number : drawn) {
    auto edge = measured(index, number);
    if (!edge) return fail(edge.error());
    curve.length += edge->length;
    curve.edges.push_back(std::move(*edge));
  }
  curve.nodes = joinEnds(index, curve.edges);
  for (const Candidate& edge : curve.edges)
    for (const int node : edge.ends) ++curve.meeting[node];
  if (const auto broken = brokenAt(curve)) return fail(*broken);
  return curve;
}

/// One drawn edge over all faces of the side: the nearest face has its places.
class EdgeOverFaces {
 public:
  EdgeOverFaces(const ShapeIndex& index, int edge, const std::set<int>& faces)
      : curve_(index.edge(edge), Direction::Forward) {
    for (const int face : faces) shadows_.emplace_back(index.edge(edge), index.face(face));
    faces_.assign(faces.begin(), faces.end());
    for (int place = 0; place <= CurveShadow::kPlaces; ++place) owners_.push_back(ownerOf(place));
  }
  [[nodiscard]] bool isNowhere() const {
    return std::all_of(owners_.begin(), owners_.end(), [](const auto& o) { return !o; });
  }
  /// Where the edge is farthest off the face it is over.
  [[nodiscard]] Note farthest(int edge) const {
    Note far{.code = NoteCode::SetbackOffFace, .edge = edge};
    for (int place = 0; place <= CurveShadow::kPlaces; ++place) {
      const auto owner = owners_[std::size_t(place)];
      if (!owner || sample(*owner, place).distance <= far.value) continue;
      far.value = sample(*owner, place).distance;
      far.where = curve_.point(double(place) / CurveShadow::kPlaces);
      far.face = faces_[*owner];
    }
    return far;
  }
  struct Piece {
    int face = 0;
    ShadowRun run;
    TopoDS_Edge edge;
  };
  [[nodiscard]] std::vector<Piece> pieces() const {
    std::vector<Piece> all;
    for (std::size_t k = 0; k < shadows_.size(); ++k) {
      double done = -1.0;
      for (int place = 0; place <= CurveShadow::kPlaces; ++place) {
        if (owners_[std::size_t(place)] != k || double(place) / CurveShadow::kPlaces <= done)
          continue;
        const ShadowRun run = shadows_[k].runRound(place);
        done = run.to;
        if (run.to > run.from) all.push_back({faces_[k], run, shadows_[k].edgeOver(run)});
      }
    }
    return all;
  }
  struct End {
    int face = 0;
    Vector3d point;
    std::optional<WayOut> out;
  };
  /// One end of the edge if it lies inside a face, and the way to the border.
  [[nodiscard]] std::optional<End> insideEnd(std::size_t end, double size) const {
    const int last = end == 0 ? 0 : CurveShadow::kPlaces, before = end == 0 ? 1 : last - 1;
    const auto owner = owners_[std::size_t(last)];
    if (!owner) return std::nullopt;
    const ShadowPoint& at = sample(*owner, last);
    const FaceDomain& face = shadows_[*owner].face();
    if (face.state(at.w) != TopAbs_IN) return std::nullopt;
    return End{faces_[*owner], at.point, straightOut(face, at.w, sample(*owner, before).w, size)};
  }

 private:
  [[nodiscard]] const ShadowPoint& sample(std::size_t shadow, int place) const {
    return shadows_[shadow].samples()[std::size_t(place)];
  }
  [[nodiscard]] std::optional<std::size_t> ownerOf(int place) const {
    std::optional<std::size_t> nearest;
    for (std::size_t k = 0; k < shadows_.size(); ++k) {
      const ShadowPoint& here = sample(k, place);
      if (here.onFace && (!nearest || here.distance < sample(*nearest, place).distance))
        nearest = k;
    }
    return nearest;
  }
  EdgeCurve curve_;
  std::deque<CurveShadow> shadows_;
  std::vector<int> faces_;
  std::vector<std::optional<std::size_t>> owners_;
};

/// The whole curve over the faces.
class Laying {
 public:
  Laying(const ShapeIndex& index, const DrawnCurve& curve, const std::set<int>& faces)
      : index_(index), curve_(curve), faces_(faces) {
    for (const Candidate& edge : curve.edges) edges_.emplace_back(index, edge.edge, faces);
  }
  /// SetbackCurveOff where the curve is nowhere over the faces, or farther than `limit` off them.
  [[nodiscard]] std::optional<Error> checkDistance(double limit) {
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const Note here = edges_[k].farthest(curve_.edges[k].edge);
      if (far_.edge == 0 || here.value > far_.value) far_ = here;
    }
    const bool isNowhere = std::all_of(
        edges_.begin(), edges_.end(), [](const EdgeOverFaces& e) { return e.isNowhere(); });
    if (isNowhere) far_ = nearest();
    if (!isNowhere && far_.value <= limit) return std::nullopt;
    return Error{.code = ErrorCode::SetbackCurveOff,
                 .edge = far_.edge,
                 .face = far_.face,
                 .where = far_.where,
                 .value = far_.value};
  }
  /// SetbackCurveShort.
  [[nodiscard]] std::optional<Error> extendEnds(LaidCurve& laid) const {
    for (std::size_t k = 0; k < edges_.size(); ++k)
      for (const std::size_t end : {0U, 1U}) {
        if (curve_.meeting.at(curve_.edges[k].ends[end]) != 1) continue;
        const auto inside = edges_[k].insideEnd(end, curve_.length);
        if (!inside) continue;
        const int edge = curve_.edges[k].edge;
        if (!inside->out || inside->out->length > kLongest * curve_.length)
          return Error{.code = ErrorCode::SetbackCurveShort,
                       .edge = edge,
                       .face = inside->face,
                       .where = inside->point,
                       .value = inside->out ? inside->out->length : 0.0};
        if (inside->out->length <= Precision::Confusion()) continue;
        laid.onFace[inside->face].push_back(inside->out->edge);
        laid.notes.push_back(
            {NoteCode::SetbackExtended, edge, inside->point, inside->out->length, inside->face});
      }
    return std::nullopt;
  }
  void lay(LaidCurve& laid) const {
    if (far_.value > Precision::Confusion()) laid.notes.push_back(far_);
    for (std::size_t k = 0; k < edges_.size(); ++k)
      for (const EdgeOverFaces::Piece& piece : edges_[k].pieces()) {
        if (piece.run.from == 0.0) widen(TopExp::FirstVertex(piece.edge), curve_.edges[k].ends[0]);
        if (piece.run.to == 1.0) widen(TopExp::LastVertex(piece.edge), curve_.edges[k].ends[1]);
        laid.onFace[piece.face].push_back(piece.edge);
      }
  }

 private:
  /// Ends that are one although they lie apart are so by their tolerance.
  void widen(const TopoDS_Vertex& vertex, int node) const {
    const double spread = curve_.spread(node);
    if (spread > 0.5 * Precision::Confusion()) BRep_Builder().UpdateVertex(vertex, 2.0 * spread);
  }
  /// Where a curve that is over no face comes nearest to one.
  [[nodiscard]] Note nearest() const {
    Note best{.code = NoteCode::SetbackOffFace, .value = std::numeric_limits<double>::infinity()};
    for (const int face : faces_) {
      const FaceProjector projector(index_.face(face));
      for (const Candidate& edge : curve_.edges)
        for (const Vector3d& point : edge.samples)
          if (const double distance = projector.nearest(point).distance; distance < best.value)
            best = {NoteCode::SetbackOffFace, edge.edge, point, distance, face};
    }
    return best;
  }

  const ShapeIndex& index_;
  const DrawnCurve& curve_;
  const std::set<int>& faces_;
  std::deque<EdgeOverFaces> edges_;
  Note far_;
};

}  // namespace

Result<LaidCurve> layOntoFaces(const ShapeIndex& index,
                               const std::vector<int>& drawn,
                               const boundary::ChainPair& pair,
                               std::size_t chain) {
  const auto curve = curveOf(index, drawn);
  if (!curve) return fail(curve.error());
  if (curve->isClosed() != pair.closed)
    return fail({.code = ErrorCode::SetbackCurveUnlike,
                 .edge = curve->edges.front().edge,
                 .detail = pair.closed ? "closed" : "open"});
  const std::set<int> faces = pair.sides.facesBeside(pair.chain(chain));
  Laying laying(index, *curve, faces);
  if (const auto off = laying.checkDistance(kFarthest * pair.sides.diagonal)) return fail(*off);
  LaidCurve laid;
  laying.lay(laid);
  if (const auto tooShort = laying.extendEnds(laid)) return fail(*tooShort);
  return laid;
}

}  // namespace fairing::occt
