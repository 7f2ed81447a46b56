// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/shape_file.h"

#include <gtest/gtest.h>

#include <BinTools.hxx>
#include <BinTools_LocationSet.hxx>
#include <BinTools_ShapeSet.hxx>
#include <TopLoc_Location.hxx>
#include <filesystem>
#include <fstream>
#include <gp_Trsf.hxx>
#include <random>
#include <sstream>

#include "occt/edge_curve.h"
#include "occt/shape_bytes.h"
#include "occt/shapes.h"

namespace fairing::occt {
namespace {

using namespace fairing::testing;
namespace fs = std::filesystem;

/// A folder of its own for every test, gone afterwards.
class ShapeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / ("fairing_test_" + std::to_string(std::random_device{}()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string fileWith(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  [[nodiscard]] std::size_t fileCount() const {
    return std::size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

 private:
  fs::path folder_;
};

ErrorCode readCode(const std::string& path) {
  const auto shape = readShape(path);
  EXPECT_FALSE(shape.has_value());
  return shape ? ErrorCode::Foreign : shape.error().code;
}

TEST_F(ShapeFile, BrepAndStepKeepEdgesFacesAndGeometry) {
  const TopoDS_Shape shape = sheetWithHole();
  const ShapeIndex before(shape);
  for (const char* name : {"a.brep", "a.BRP", "a.step", "a.STP"}) {
    ASSERT_TRUE(writeShape(shape, path(name)).has_value()) << name;
    const auto back = readShape(path(name));
    ASSERT_TRUE(back.has_value()) << name;
    const ShapeIndex after(*back);
    ASSERT_EQ(after.edgeCount(), before.edgeCount()) << name;
    ASSERT_EQ(after.faceCount(), before.faceCount()) << name;
    EXPECT_NEAR(area(*back), area(shape), 1e-9 * area(shape)) << name;
  }
  EXPECT_EQ(fileCount(), 4u);
}

TEST_F(ShapeFile, BrepKeepsEdgeNumbersAndCurvesToTheLastDigits) {
  const TopoDS_Shape shape = sheetWithHole();
  ASSERT_TRUE(writeShape(shape, path("a.brep")).has_value());
  const auto back = readShape(path("a.brep"));
  ASSERT_TRUE(back.has_value());
  const ShapeIndex before(shape), after(*back);
  for (int edge = 1; edge <= before.edgeCount(); ++edge) {
    const EdgeCurve a(before.edge(edge), Direction::Forward),
        b(after.edge(edge), Direction::Forward);
    EXPECT_LT((a.point(0.37) - b.point(0.37)).norm(), 1e-13 * 50.0);
  }
}

TEST_F(ShapeFile, RefusesWhatIsNoShape) {
  EXPECT_EQ(readCode(path("missing.brep")), ErrorCode::FileUnreadable);
  EXPECT_EQ(readCode(path("")), ErrorCode::FileUnreadable);
  EXPECT_EQ(readCode(fileWith("a.txt", "CASCADE Topology V1")), ErrorCode::FileFormatUnknown);
  EXPECT_EQ(readCode(fileWith("empty.brep", "")), ErrorCode::FileNotAShape);
  EXPECT_EQ(readCode(fileWith("empty.step", "")), ErrorCode::FileNotAShape);
  EXPECT_EQ(readCode(fileWith("words.brep", "These are words.\n")), ErrorCode::FileNotAShape);
  EXPECT_EQ(readCode(fileWith("words.step", "These are words.\n")), ErrorCode::FileNotAShape);
  EXPECT_EQ(readCode(fileWith("zero.brep", std::string(1000, '\0'))), ErrorCode::FileNotAShape);
  EXPECT_EQ(readCode(fileWith(
                "head.brep", "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\n")),
            ErrorCode::FileNotAShape);
}

TEST_F(ShapeFile, RefusesFilesCutShort) {
  const auto bytes = bytesFromShape(box(1, 2, 3));
  ASSERT_TRUE(bytes.has_value());
  for (int percent = 5; percent < 100; percent += 5) {
    const std::string part = bytes->substr(0, bytes->size() * std::size_t(percent) / 100);
    EXPECT_EQ(readCode(fileWith("cut.brep", part)), ErrorCode::FileNotAShape) << percent << " %";
  }
}

TEST_F(ShapeFile, WritesAllOrNothing) {
  const TopoDS_Shape shape = box(1, 2, 3);
  const auto codeOf = [&](const std::string& to) {
    const auto written = writeShape(shape, to);
    return written ? ErrorCode::Foreign : written.error().code;
  };
  EXPECT_EQ(codeOf(path("no/such/folder/a.brep")), ErrorCode::FileUnwritable);
  EXPECT_EQ(codeOf(path("a.obj")), ErrorCode::FileFormatUnknown);
  EXPECT_EQ(codeOf(path("a")), ErrorCode::FileFormatUnknown);
  fs::create_directory(path("folder.brep"));
  EXPECT_EQ(codeOf(path("folder.brep")), ErrorCode::FileUnwritable);
  EXPECT_TRUE(fs::is_directory(path("folder.brep")));
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(ShapeFile, ReplacesAnOldFileOnlyByACompleteOne) {
  const std::string file = fileWith("a.brep", "old");
  ASSERT_TRUE(writeShape(box(1, 2, 3), file).has_value());
  const auto back = readShape(file);
  ASSERT_TRUE(back.has_value());
  EXPECT_NEAR(volume(*back), 6.0, 1e-9);
  EXPECT_EQ(fileCount(), 1u);
}

TEST(ShapeBytes, TextKeepsTheShape) {
  const TopoDS_Shape shape = sheetWithHole();
  const auto bytes = bytesFromShape(shape);
  ASSERT_TRUE(bytes.has_value());
  const auto back = shapeFromBytes(*bytes);
  ASSERT_TRUE(back.has_value());
  EXPECT_NEAR(area(*back), area(shape), 1e-9);
  EXPECT_EQ(ShapeIndex(*back).edgeCount(), ShapeIndex(shape).edgeCount());
}

/// What FreeCAD's exportBinary writes: the set of shapes, then index, location and orientation of
/// the root.
std::string freecadBinary(const TopoDS_Shape& shape) {
  BinTools_ShapeSet set;
  set.SetFormatNb(3);
  const int root = set.Add(shape);
  const int location = set.Locations().Index(shape.Location());
  std::ostringstream stream;
  set.Write(stream);
  BinTools::PutInteger(stream, root);
  BinTools::PutInteger(stream, location);
  BinTools::PutInteger(stream, int(shape.Orientation()));
  return stream.str();
}

TEST(ShapeBytes, ReadsFreecadsBinary) {
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(1, 2, 3));
  const TopoDS_Shape shape = sheetWithHole().Moved(TopLoc_Location(shift)).Reversed();
  const auto back = shapeFromBytes(freecadBinary(shape));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->Orientation(), TopAbs_REVERSED);
  EXPECT_NEAR(area(*back), area(shape), 1e-9);
  const ShapeIndex before(shape), after(*back);
  ASSERT_EQ(after.edgeCount(), before.edgeCount());
  const EdgeCurve a(before.edge(3), Direction::Forward), b(after.edge(3), Direction::Forward);
  EXPECT_LT((a.point(0.4) - b.point(0.4)).norm(), 1e-14 * 50.0);
}

TEST(ShapeBytes, RefusesBinaryCutShort) {
  const std::string bytes = freecadBinary(box(1, 2, 3));
  for (int percent = 5; percent < 100; percent += 5) {
    const auto part = shapeFromBytes(bytes.substr(0, bytes.size() * std::size_t(percent) / 100));
    EXPECT_FALSE(part.has_value()) << percent << " %";
  }
}

TEST(ShapeBytes, RefusesBytesThatAreNoShape) {
  for (const std::string& bytes : {std::string(),
                                   std::string("Open CASCADE Topology V3 (c)\n"),
                                   std::string(300, 'x'),
                                   std::string("DBRep_DrawableShape")}) {
    const auto shape = shapeFromBytes(bytes);
    ASSERT_FALSE(shape.has_value());
    EXPECT_EQ(shape.error().code, ErrorCode::FileNotAShape);
  }
}

}  // namespace
}  // namespace fairing::occt
