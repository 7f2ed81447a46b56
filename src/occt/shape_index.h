// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace fairing::occt {

/// One appearance of an edge in the border of a face. A seam appears twice in its face.
struct EdgeUse {
  int face = 0;      ///< FreeCAD's FaceN
  TopoDS_Edge edge;  ///< oriented so that the face, seen against its normal, lies to the left
};

/// Edges and faces of a shape under FreeCAD's numbers: EdgeN and FaceN count from 1 in the order of
/// TopExp::MapShapes. Built once a shape, in linear time.
class ShapeIndex {
 public:
  explicit ShapeIndex(const TopoDS_Shape& shape);

  [[nodiscard]] const TopoDS_Shape& shape() const { return shape_; }
  [[nodiscard]] int edgeCount() const { return static_cast<int>(edges_.size()); }
  [[nodiscard]] int faceCount() const { return static_cast<int>(faces_.size()); }
  [[nodiscard]] bool hasEdge(int number) const { return number >= 1 && number <= edgeCount(); }
  [[nodiscard]] bool hasFace(int number) const { return number >= 1 && number <= faceCount(); }
  [[nodiscard]] const TopoDS_Edge& edge(int number) const { return edges_[slot(number)]; }
  [[nodiscard]] const TopoDS_Face& face(int number) const { return faces_[slot(number)]; }
  /// Every appearance of the edge, by ascending face number.
  [[nodiscard]] const std::vector<EdgeUse>& uses(int edge) const { return uses_[slot(edge)]; }

 private:
  [[nodiscard]] static std::size_t slot(int number) { return static_cast<std::size_t>(number - 1); }

  TopoDS_Shape shape_;
  std::vector<TopoDS_Edge> edges_;
  std::vector<TopoDS_Face> faces_;
  std::vector<std::vector<EdgeUse>> uses_;
};

}  // namespace fairing::occt
