// SPDX-License-Identifier: BSD-3-Clause
// Time that the discriminator takes for one object in one frame, by its number of hits.
#include <benchmark/benchmark.h>

#include <random>

#include "vdamf/tracking/discrimination/classify.h"
#include "vdamf/tracking/discrimination/features.h"

namespace
{
using namespace vdamf;

// Rear and side of a car, 1.5 m high, seen from behind on the left.
Cluster carHits(std::size_t count)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(0.0F, 1.0F);
    Cluster c;
    for (std::size_t i = 0; i < count; ++i)
    {
        const bool onSide = i % 3 != 0;
        c.x.push_back(onSide ? -2.2F + 4.4F * any(random) : -2.2F);
        c.y.push_back(onSide ? 0.9F : -0.9F + 1.8F * any(random));
        c.height.push_back(0.25F + 1.25F * any(random));
        c.z.push_back(c.height.back());
    }
    return c;
}

void judgeObject(benchmark::State& state)
{
    const Cluster cluster = carHits(static_cast<std::size_t>(state.range(0)));
    ObjectView view;
    view.box = {0.0, 0.0, 0.0, 4.4, 1.8};
    view.sensor = {-14.0, 8.0};
    view.clusters = {&cluster};
    view.match = 0.6;
    view.frameHits = 60000;
    const DiscriminatorModel& model = defaultDiscriminatorModel();
    for (auto _ : state)
    {
        const double score = objectScore(view, model);
        benchmark::DoNotOptimize(frameLogOdds(model.frame, score, cluster.size()));
    }
}
BENCHMARK(judgeObject)
    ->Arg(10)
    ->Arg(50)
    ->Arg(200)
    ->Arg(1000)
    ->Arg(5000)
    ->Unit(benchmark::kMicrosecond);
}  // namespace

BENCHMARK_MAIN();
