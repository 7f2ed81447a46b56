// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <Standard_Failure.hxx>
#include <exception>
#include <type_traits>

#include "core/base/result.h"

namespace fairing::occt {

/// Runs `work`, which returns a Result, and turns whatever the CAD kernel throws into
/// ErrorCode::Foreign.
template <class Work>
[[nodiscard]] std::invoke_result_t<Work> guarded(Work&& work) {
  const auto foreign = [](const char* message) {
    return fail({.code = ErrorCode::Foreign, .detail = message != nullptr ? message : ""});
  };
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    const char* message = failure.GetMessageString();
    return foreign(message != nullptr && *message != '\0' ? message
                                                          : failure.DynamicType()->Name());
  } catch (const std::exception& failure) {
    return foreign(failure.what());
  }
}

}  // namespace fairing::occt
