// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cli/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "occt/shape_file.h"
#include "text/error_text.h"

namespace fairing::cli {
namespace {

namespace fs = std::filesystem;

Error unwritable(const std::string& path) {
  return {.code = ErrorCode::FileUnwritable, .detail = path};
}

std::string partialName(const std::string& path) {
  return path + ".part";
}

Result<void> checkJsonWritable(const std::string& path) {
  std::error_code status;
  const bool taken = fs::exists(path, status) && !fs::is_regular_file(path, status);
  const bool open = !taken && static_cast<bool>(std::ofstream(partialName(path)));
  fs::remove(partialName(path), status);
  if (!open) return fail(unwritable(path));
  return {};
}

}  // namespace

void complain(const std::string& sentence) {
  std::string line = sentence;
  std::replace(line.begin(), line.end(), '\n', ' ');
  fmt::print(stderr, "fairing: {}\n", line);
}

Outcome complain(const Error& error) {
  complain(text::sentence(error));
  return Outcome::NothingWritten;
}

Result<void> checkOutputs(const std::string& out, const std::string& report) {
  if (const auto writable = out.empty() ? Result<void>{} : occt::checkWritable(out); !writable)
    return fail(writable.error());
  return report.empty() ? Result<void>{} : checkJsonWritable(report);
}

Result<void> writeJson(const nlohmann::json& json, const std::string& path) {
  if (auto allowed = checkJsonWritable(path); !allowed) return allowed;
  std::error_code status;
  std::ofstream file(partialName(path));
  file << json.dump(1) << '\n';
  file.close();
  if (file) fs::rename(partialName(path), path, status);
  if (!file || status) {
    fs::remove(partialName(path), status);
    return fail(unwritable(path));
  }
  return {};
}

}  // namespace fairing::cli
