// SPDX-License-Identifier: LGPL-2.1-or-later
#include "benchmarks/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace fairing::benchmarks {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();  // printed as "nan"

// Those that are numbers.
std::vector<double> present(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values;
}

double least(const std::vector<double>& values) {
  return values.empty() ? kMissing : *std::min_element(values.begin(), values.end());
}

double at(const std::map<std::string, double>& values, const std::string& method) {
  const auto found = values.find(method);
  return found == values.end() ? kMissing : found->second;
}

// The middle value; the mean of the two middle ones of an even number.
double median(std::vector<double> values) {
  if (values.empty()) return kMissing;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

bool Comparison::ReportContext(const Context& context) {
  PrintBasicContext(&GetErrorStream(), context);
  return true;
}

void Comparison::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const std::string& name = run.run_name.function_name;
    if (run.error_occurred) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), run.error_message.c_str());
      complete_ = false;
    }
    if (run.error_occurred || run.aggregate_name != "median") continue;
    const auto slash = name.find('/');
    const std::string method = name.substr(slash + 1);
    Row& row = rows_[name.substr(0, slash)];
    row.time[method] = run.GetAdjustedRealTime();
    for (const auto& [counter, values] : {std::pair(kAngle, &row.angle), std::pair(kGap, &row.gap)})
      if (run.counters.contains(counter)) (*values)[method] = run.counters.at(counter).value;
  }
}

void Comparison::Finalize() {
  printTimes();
  printDeviations();
}

void Comparison::printTimes() const {
  std::printf("\n%-16s%10s%14s%8s%12s%14s%8s\n",
              "median, ms",
              "Fairing",
              "MakeFilling",
              "ratio",
              "bare solve",
              "Constrained",
              "ratio");
  std::vector<double> wholeRatios;
  std::vector<double> solveRatios;
  for (const auto& [hole, row] : rows_) {
    wholeRatios.push_back(at(row.time, kMakeFilling) / at(row.time, kFairing));
    solveRatios.push_back(at(row.time, kConstrained) / at(row.time, kSolve));
    std::printf("%-16s%10.2f%14.2f%8.2f%12.2f%14.2f%8.2f\n",
                hole.c_str(),
                at(row.time, kFairing),
                at(row.time, kMakeFilling),
                wholeRatios.back(),
                at(row.time, kSolve),
                at(row.time, kConstrained),
                solveRatios.back());
  }
  wholeRatios = present(wholeRatios);
  solveRatios = present(solveRatios);
  std::printf("%-40s%8.2f%26s%8.2f\n", "median", median(wholeRatios), "", median(solveRatios));
  std::printf("%-40s%8.2f%26s%8.2f\n", "least", least(wholeRatios), "", least(solveRatios));
}

void Comparison::printDeviations() const {
  std::printf("\n%-16s%33s%33s\n", "", "largest angle, degrees", "largest gap, micrometres");
  std::printf("%-16s", "");
  for (int i = 0; i < 2; ++i) std::printf("%10s%12s%11s", "Fairing", "MakeFilling", "Constr.");
  std::printf("\n");
  for (const auto& [hole, row] : rows_) {
    std::printf("%-16s", hole.c_str());
    for (const auto* values : {&row.angle, &row.gap})
      std::printf("%10.4f%12.4f%11.4f",
                  at(*values, kFairing),
                  at(*values, kMakeFilling),
                  at(*values, kConstrained));
    std::printf("\n");
  }
}

}  // namespace fairing::benchmarks
