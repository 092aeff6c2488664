// SPDX-License-Identifier: BSD-3-Clause
// Time of the auction, and of the search for clusters that targets share, by the number of targets:
// lanes of cars on a square, each seen in three clusters, some of which two cars want.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "vdamf/tracking/association/shared_clusters.h"

namespace
{
using namespace vdamf;

struct Scene
{
    std::vector<PredictedTarget> targets;
    std::vector<Hits> clusters;
};

Hits lineOfHits(double x, double y, double length, std::mt19937& random)
{
    std::normal_distribution<double> noise(0.0, 0.05);
    constexpr int kHits = 12;
    Hits hits;
    for (int k = 0; k < kHits; ++k)
    {
        hits.x.push_back(x + length * k / kHits + noise(random));
        hits.y.push_back(y + noise(random));
        hits.weight.push_back(3.0);
        hits.totalWeight += 3.0;
    }
    return hits;
}

Scene sceneOf(int cars)
{
    constexpr double kAlong = 5.5;  // m, bumper to bumper
    constexpr double kAcross = 3.0;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> sigma(0.1, 0.8);
    const int lanes = std::max(1, static_cast<int>(std::sqrt(cars * kAlong / kAcross)));
    Scene scene;
    for (int k = 0; k < cars; ++k)
    {
        const double x = kAlong * (k / lanes);
        const double y = kAcross * (k % lanes);
        scene.targets.push_back({{x, y, 0.0, 4.5, 1.8},
                                 Eigen::Vector2d::Constant(sigma(random)),
                                 0.2,
                                 0.1,
                                 {10.0, 0.0}});
        scene.clusters.push_back(lineOfHits(x - 2.2, y - 0.9, 1.8, random));
        scene.clusters.push_back(lineOfHits(x + 0.4, y - 0.9, 1.7, random));
        scene.clusters.push_back(lineOfHits(x + 2.5, y - 0.6, 0.5, random));
    }
    return scene;
}

void auction(benchmark::State& state)
{
    const Scene scene = sceneOf(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(assignClusters(scene.targets, scene.clusters, {}));
    state.SetComplexityN(state.range(0));
}

void shared(benchmark::State& state)
{
    const Scene scene = sceneOf(static_cast<int>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(sharedClusters(scene.targets, scene.clusters, {}));
    state.SetComplexityN(state.range(0));
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
    for (const int cars : {50, 500, 5000, 10000}) benchmark->Arg(cars);
    benchmark->Unit(benchmark::kMicrosecond)->Complexity(benchmark::oN);
}

BENCHMARK(auction)->Apply(sizes);
BENCHMARK(shared)->Apply(sizes);
}  // namespace

BENCHMARK_MAIN();
