// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/shape_index.h"

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace fairing::occt {

ShapeIndex::ShapeIndex(const TopoDS_Shape& shape) : shape_(shape) {
  if (shape.IsNull()) return;
  TopTools_IndexedMapOfShape edges;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopExp::MapShapes(shape, TopAbs_FACE, faces);

  edges_.reserve(static_cast<std::size_t>(edges.Extent()));
  for (int i = 1; i <= edges.Extent(); ++i) edges_.push_back(TopoDS::Edge(edges(i)));

  uses_.resize(edges_.size());
  faces_.reserve(static_cast<std::size_t>(faces.Extent()));
  for (int i = 1; i <= faces.Extent(); ++i) {
    faces_.push_back(TopoDS::Face(faces(i)));
    for (TopExp_Explorer it(faces_.back(), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      // INTERNAL and EXTERNAL edges do not bound the face.
      if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
      uses_[slot(edges.FindIndex(edge))].push_back({i, edge});
    }
  }
}

}  // namespace fairing::occt
