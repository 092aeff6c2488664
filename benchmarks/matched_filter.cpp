// SPDX-License-Identifier: BSD-3-Clause
// Time of the matched filter: the response with gradient and Hessian by the reference and by every
// path of the kernel that this processor has, and whole fits.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "matched_filter/match_kernel.h"
#include "tracking/matched_filter/example_hits.h"
#include "vdamf/tracking/matched_filter/fit.h"

namespace
{
using namespace vdamf;

const OrientedBox kCar{14.0, 4.0, 0.8, 4.5, 1.8};

// 0.3 m and 8 degrees away from the car.
const OrientedBox kStart{14.2, 3.78, 0.8 + 8.0 * kPi / 180.0, 4.5, 1.8};

Hits carHits(const benchmark::State& state)
{
    return exampleHits(kCar, static_cast<int>(state.range(0)), 0.02, 0.1, 1);
}

void countHits(benchmark::State& state)
{
    state.counters["per_hit"] = benchmark::Counter(
        static_cast<double>(state.range(0)),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void reference(benchmark::State& state)
{
    const Hits hits = carHits(state);
    const double phi = bearingToSensor(kStart, Eigen::Vector2d::Zero());
    for (auto _ : state)
        benchmark::DoNotOptimize(matchResponse(hits, FilterShape::paper(), kStart, phi));
    countHits(state);
}

void kernel(benchmark::State& state, KernelPath path)
{
    const std::vector<KernelPath> paths = kernelPaths();
    if (std::find(paths.begin(), paths.end(), path) == paths.end())
    {
        state.SkipWithError("this processor does not have the instructions");
        return;
    }
    const KernelHits hits = kernelHits(carHits(state), kStart.centre());
    const double phi = bearingToSensor(kStart, Eigen::Vector2d::Zero());
    for (auto _ : state)
        benchmark::DoNotOptimize(kernelResponse(hits, FilterShape::paper(), kStart, phi, path));
    countHits(state);
}

// A fit by sums in double precision (a tolerance below 1e-4) or by the kernel.
void fit(benchmark::State& state, double tolerance)
{
    const Hits hits = carHits(state);
    FitOptions options;
    options.tolerance = tolerance;
    Fit result;
    for (auto _ : state)
    {
        result =
            fitMatchedFilter(hits, FilterShape::paper(), Eigen::Vector2d::Zero(), kStart, options);
        benchmark::DoNotOptimize(result);
    }
    state.counters["iterations"] = result.iterations;
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
    for (const int hits : {30, 100, 300, 1000}) benchmark->Arg(hits);
}

BENCHMARK(reference)->Apply(sizes);
BENCHMARK_CAPTURE(kernel, baseline, KernelPath::Baseline)->Apply(sizes);
BENCHMARK_CAPTURE(kernel, avx2, KernelPath::Avx2)->Apply(sizes);
BENCHMARK_CAPTURE(kernel, avx512, KernelPath::Avx512)->Apply(sizes);
BENCHMARK_CAPTURE(fit, double, 0.99e-4)->Apply(sizes)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(fit, single, 1e-4)->Apply(sizes)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(fit, single_to_a_millimetre, 1e-3)->Apply(sizes)->Unit(benchmark::kMicrosecond);
}  // namespace

BENCHMARK_MAIN();
