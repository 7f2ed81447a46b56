// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/shape_bytes.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <BinTools_LocationSet.hxx>
#include <BinTools_ShapeSet.hxx>

#include <sstream>
#include <streambuf>

#include "occt/guarded.h"

namespace fairing::occt {
namespace {

/// Reads from memory without a copy.
class MemoryBuffer : public std::streambuf {
 public:
  explicit MemoryBuffer(std::string_view bytes) {
    char* first =
        const_cast<char*>(bytes.data());  // std::streambuf wants it so; nothing is written
    setg(first, first, first + bytes.size());
  }

 protected:
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
    char* base = from == std::ios_base::beg   ? eback()
                 : from == std::ios_base::cur ? gptr()
                                              : egptr();
    char* target = base + offset;
    if (target < eback() || target > egptr()) return pos_type(off_type(-1));
    setg(eback(), target, egptr());
    return pos_type(gptr() - eback());
  }
  pos_type seekpos(pos_type position, std::ios_base::openmode mode) override {
    return seekoff(off_type(position), std::ios_base::beg, mode);
  }
};

Error notAShape() {
  return {.code = ErrorCode::FileNotAShape, .detail = "The data"};
}

/// FreeCAD's exportBinary: the set of shapes, then index, location and orientation of the root as
/// plain integers.
TopoDS_Shape readFreecadBinary(std::istream& stream) {
  BinTools_ShapeSet set;
  set.Read(stream);
  int shape = 0, location = 0, orientation = 0;
  BinTools::GetInteger(stream, shape);
  BinTools::GetInteger(stream, location);
  BinTools::GetInteger(stream, orientation);
  if (!stream || shape < 1 || shape > set.NbShapes() || orientation < TopAbs_FORWARD ||
      orientation > TopAbs_EXTERNAL) {
    return {};
  }
  TopoDS_Shape result = set.Shape(shape);
  result.Location(set.Locations().Location(location));
  result.Orientation(TopAbs_Orientation(orientation));
  return result;
}

TopoDS_Shape readText(std::istream& stream) {
  TopoDS_Shape shape;
  BRepTools::Read(shape, stream, BRep_Builder());
  return shape;
}

}  // namespace

Result<TopoDS_Shape> shapeFromBytes(std::string_view bytes) {
  constexpr std::size_t kHeader = 200;
  const std::string_view head = bytes.substr(0, kHeader);
  const bool isText = head.find("DBRep_DrawableShape") != std::string_view::npos ||
                      head.find("CASCADE Topology V") != std::string_view::npos;
  const bool isBinary = head.find("Open CASCADE Topology V") != std::string_view::npos;
  if (!isText && !isBinary) return fail(notAShape());
  auto shape = guarded([&]() -> Result<TopoDS_Shape> {
    MemoryBuffer buffer(bytes);
    std::istream stream(&buffer);
    // The kernel's readers wait for words that never come in a file cut short: the first one
    // missing is an exception.
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    return isBinary ? readFreecadBinary(stream) : readText(stream);
  });
  if (!shape || shape->IsNull()) return fail(notAShape());
  return shape;
}

Result<std::string> bytesFromShape(const TopoDS_Shape& shape) {
  return guarded([&]() -> Result<std::string> {
    std::ostringstream stream;
    BRepTools::Write(shape, stream, false, false, TopTools_FormatVersion_CURRENT);
    return stream.str();
  });
}

}  // namespace fairing::occt
