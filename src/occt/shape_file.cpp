// SPDX-License-Identifier: LGPL-2.1-or-later
#include "occt/shape_file.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "occt/guarded.h"
#include "occt/shape_bytes.h"

namespace fairing::occt {
namespace {

namespace fs = std::filesystem;

enum class Format { Unknown, Brep, Step };

Format formatOf(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return char(std::tolower(c));
  });
  if (extension == ".brep" || extension == ".brp") return Format::Brep;
  if (extension == ".step" || extension == ".stp") return Format::Step;
  return Format::Unknown;
}

Error fileError(ErrorCode code, const std::string& path) {
  return {.code = code, .detail = path};
}

/// The kernel reports file troubles on the console; here they are errors, so it is told to be
/// quiet.
class QuietKernel {
 public:
  QuietKernel() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~QuietKernel() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  QuietKernel(const QuietKernel&) = delete;
  QuietKernel& operator=(const QuietKernel&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

Result<TopoDS_Shape> readStep(const std::string& path) {
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() < 1) {
    return fail(fileError(ErrorCode::FileNotAShape, path));
  }
  return reader.OneShape();
}

Result<TopoDS_Shape> readBrep(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) return fail(fileError(ErrorCode::FileUnreadable, path));
  auto shape = shapeFromBytes(bytes);
  if (!shape) return fail(fileError(ErrorCode::FileNotAShape, path));
  return *shape;
}

/// A name beside the file itself, so that renaming is one step.
std::string partialName(const std::string& path) {
  return path + ".part" + std::to_string(std::random_device{}());
}

bool writeTo(const TopoDS_Shape& shape, const std::string& path, Format format) {
  if (format == Format::Step) {
    STEPControl_Writer writer;
    return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
           writer.Write(path.c_str()) == IFSelect_RetDone;
  }
  std::ofstream file(path, std::ios::binary);
  BRepTools::Write(shape, file, false, false, TopTools_FormatVersion_CURRENT);
  file.close();
  return static_cast<bool>(file);
}

}  // namespace

Result<TopoDS_Shape> readShape(const std::string& path) {
  std::error_code status;
  if (!fs::is_regular_file(path, status) || !std::ifstream(path)) {
    return fail(fileError(ErrorCode::FileUnreadable, path));
  }
  const Format format = formatOf(path);
  if (format == Format::Unknown) return fail(fileError(ErrorCode::FileFormatUnknown, path));
  const QuietKernel quiet;
  auto shape = guarded([&] { return format == Format::Step ? readStep(path) : readBrep(path); });
  if (!shape && shape.error().code == ErrorCode::Foreign) {
    return fail(fileError(ErrorCode::FileNotAShape, path));
  }
  if (shape && shape->IsNull()) return fail(fileError(ErrorCode::FileNotAShape, path));
  return shape;
}

Result<void> checkWritable(const std::string& path) {
  if (formatOf(path) == Format::Unknown) return fail(fileError(ErrorCode::FileFormatUnknown, path));
  std::error_code status;
  const bool taken = fs::exists(path, status) && !fs::is_regular_file(path, status);
  const std::string partial = partialName(path);
  const bool open = !taken && static_cast<bool>(std::ofstream(partial));
  fs::remove(partial, status);
  if (!open) return fail(fileError(ErrorCode::FileUnwritable, path));
  return {};
}

Result<void> writeShape(const TopoDS_Shape& shape, const std::string& path) {
  if (auto allowed = checkWritable(path); !allowed) return allowed;
  const Format format = formatOf(path);
  const QuietKernel quiet;
  const std::string partial = partialName(path);
  const auto written = guarded([&]() -> Result<bool> { return writeTo(shape, partial, format); });
  std::error_code status;
  if (written && *written) {
    fs::rename(partial, path, status);
    if (!status) return {};
  }
  fs::remove(partial, status);
  return fail(fileError(ErrorCode::FileUnwritable, path));
}

}  // namespace fairing::occt
