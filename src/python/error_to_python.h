// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <exception>
#include <utility>

#include "core/base/result.h"

namespace fairing::python {

/// Carries an Error to Python, where it becomes a FairingError.
class Failure : public std::exception {
 public:
  explicit Failure(Error error) : error_(std::move(error)) {}
  [[nodiscard]] const Error& error() const { return error_; }
  [[nodiscard]] const char* what() const noexcept override { return "fairing::python::Failure"; }

 private:
  Error error_;
};

/// The value, or a Failure thrown.
template <class T>
[[nodiscard]] T valueOf(Result<T> result) {
  if (!result) throw Failure(std::move(result.error()));
  return std::move(*result);
}

}  // namespace fairing::python
