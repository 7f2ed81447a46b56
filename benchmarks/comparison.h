// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace fairing::benchmarks {

/// What is timed on a hole. The name of a benchmark is "hole/method".
inline const std::string kFairing = "fairing";
inline const std::string kSolve = "fairing_solve";
inline const std::string kMakeFilling = "make_filling";
inline const std::string kConstrained = "constrained_filling";

/// Counters every method leaves: what the report measured on its faces.
inline const std::string kAngle = "angle_deg";
inline const std::string kGap = "gap_um";

/// Keeps the median time of every method on every hole and prints them side by side, with ratios.
class Comparison : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

  /// Whether every benchmark ran.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  struct Row {
    std::map<std::string, double> time;   ///< ms, by method
    std::map<std::string, double> angle;  ///< largest inside the edges, degrees
    std::map<std::string, double> gap;    ///< largest, micrometres
  };

  void printTimes() const;
  void printDeviations() const;

  std::map<std::string, Row> rows_;  ///< by hole
  bool complete_ = true;
};

}  // namespace fairing::benchmarks
