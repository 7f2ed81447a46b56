// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <benchmark/benchmark.h>

#include <string>

namespace fairing::benchmarks {

/// Registers a benchmark as all of ours are run: milliseconds, and medians of five repetitions.
template <class Function>
benchmark::internal::Benchmark* add(const std::string& name, Function function) {
  constexpr int kRepetitions = 5;
  return benchmark::RegisterBenchmark(name.c_str(), function)
      ->Unit(benchmark::kMillisecond)
      ->Repetitions(kRepetitions)
      ->ReportAggregatesOnly();
}

/// The main() of programs whose benchmarks are all of these: `addAll` registers them. 2 for an
/// argument that nobody knows.
template <class AddAll>
int runAll(int argc, char** argv, const AddAll& addAll) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  addAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace fairing::benchmarks
