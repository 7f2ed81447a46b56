// SPDX-License-Identifier: LGPL-2.1-or-later
#include "core/layout/seam_frames.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace fairing::layout {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// first * a + second * b = along * e for vectors of the plane, a to the left of e, b to the right.
SeamFrame frameOf(const Vector2d& a, const Vector2d& b, const Vector2d& e) {
  const double left = cross(e, a), right = -cross(e, b);
  SeamFrame frame;
  frame.first = 2.0 * right / (left + right);
  frame.second = 2.0 * left / (left + right);
  frame.along = (frame.first * a + frame.second * b).dot(e) / e.squaredNorm();
  return frame;
}

// The vertex before the start (forward = false) or after the end of a quad's edge.
int beside(const QuadMesh& mesh, const QuadEdge& e, bool forward) {
  const auto& vertices = mesh.quads[static_cast<std::size_t>(e.quad)].vertices;
  const auto k = static_cast<std::size_t>(e.edge);
  return vertices[(k + (forward ? 2 : 3)) % 4];
}

SeamFrame innerFrame(const QuadMesh& mesh, const QuadSeam& seam, bool atEnd) {
  const int here = atEnd ? seam.end : seam.start, there = atEnd ? seam.start : seam.end;
  const Vector2d along = mesh.way(here, there);
  return frameOf(mesh.way(here, beside(mesh, seam.first, atEnd)),
                 mesh.way(here, beside(mesh, seam.second, !atEnd)),
                 atEnd ? Vector2d(-along) : along);
}

// The corner of the loop at a vertex of the mesh.
const boundary::Corner& cornerAt(const LayoutPlan& plan, int vertex) {
  const auto& loop = plan.cut.loop;
  return loop.corners[loop.previous(static_cast<std::size_t>(vertex))];
}

// The loop passes the vertex from `before` to `after`, the hole to its left. Looking out, the patch
// on the left lies along `after`; looking in, along `before`.
SeamFrame borderFrame(const LayoutPlan& plan, const QuadSeam& seam, bool atEnd) {
  const auto& loop = plan.cut.loop;
  const auto j = static_cast<std::size_t>(atEnd ? seam.end : seam.start);
  const std::size_t earlier = loop.previous(j);
  const Vector3d after = loop.sides[j].ribbon.curve(0.0).derivative;
  const Vector3d before = loop.sides[earlier].ribbon.curve(1.0).derivative;
  const double la = after.norm(), lb = before.norm();
  SeamFrame frame;
  frame.first = 2.0 * (atEnd ? lb : la) / (la + lb);
  frame.second = 2.0 * (atEnd ? la : lb) / (la + lb);
  const boundary::Corner& corner = loop.corners[earlier];
  if (corner.isNearlyStraight()) return frame;
  // The unit vectors along both ways sum up to 2 cos(inside / 2) times the way into the hole.
  const double inward = 2.0 * la * lb / (la + lb) * 2.0 *
                        std::cos(0.5 * corner.insideAngle * std::numbers::pi / 180.0);
  const double length = plan.mesh.way(seam.start, seam.end).norm();
  frame.along = (atEnd ? -inward : inward) / length;
  return frame;
}

}  // namespace

Seam seamOf(const LayoutPlan& plan, const QuadSeam& from) {
  Seam seam;
  seam.first = from.first.quad;
  seam.second = from.second.quad;
  seam.firstEdge = from.first.edge;
  seam.secondEdge = from.second.edge;
  seam.continuity = plan.inner;
  seam.vertices = {from.start, from.end};
  for (std::size_t k = 0; k < 2; ++k) {
    seam.inside[k] = plan.mesh.inside[static_cast<std::size_t>(seam.vertices[k])];
    seam.frames[k] =
        seam.inside[k] ? innerFrame(plan.mesh, from, k == 1) : borderFrame(plan, from, k == 1);
    if (!seam.inside[k]) seam.crease = seam.crease || cornerAt(plan, seam.vertices[k]).crease;
  }
  return seam;
}

}  // namespace fairing::layout
