// SPDX-License-Identifier: BSD-3-Clause
// Time of ground removal and clustering for one HDL-64E frame: a street that this program makes,
// and a KITTI scan where VDAMF_DATA_DIR names the recordings.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "vdamf/tracking/preprocessing/clustering.h"
#include "vdamf/tracking/types/geometry.h"

namespace
{
using namespace vdamf;

struct Block
{
    float minX, maxX, minY, maxY, maxZ;
};

// Parked cars on both sides of a straight street between two facades; the sensor is the origin.
std::vector<Block> street()
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> jitter(-0.3F, 0.3F);
    std::vector<Block> blocks{{-90.0F, 90.0F, 12.0F, 13.0F, 8.0F},
                              {-90.0F, 90.0F, -13.0F, -12.0F, 8.0F}};
    for (float x = -78.0F; x < 78.0F; x += 6.5F)
        for (const float y : {-6.0F, 5.0F})
        {
            const float cx = x + jitter(random);
            const float cy = y + jitter(random);
            blocks.push_back({cx - 2.2F, cx + 2.2F, cy - 0.9F, cy + 0.9F, -0.2F});
        }
    return blocks;
}

float firstHit(const std::vector<Block>& blocks, float dx, float dy, float dz)
{
    constexpr float kSensorHeight = 1.73F;
    float nearest = dz < 0.0F ? -kSensorHeight / dz : 1e9F;
    for (const Block& b : blocks)
    {
        const float x0 = b.minX / dx;
        const float x1 = b.maxX / dx;
        const float y0 = b.minY / dy;
        const float y1 = b.maxY / dy;
        const float in = std::max(std::min(x0, x1), std::min(y0, y1));
        const float out = std::min(std::max(x0, x1), std::max(y0, y1));
        if (in > 0.0F && in < out && in < nearest && in * dz < b.maxZ) nearest = in;
    }
    return nearest;
}

LadarFrame streetFrame()
{
    std::mt19937 random(2);
    std::normal_distribution<float> noise(0.0F, 0.02F);
    const std::vector<Block> blocks = street();
    LadarFrame frame;
    for (int beam = 0; beam < 64; ++beam)
        for (int column = 0; column < 1900; ++column)
        {
            const double elevation = (2.0 - 26.8 * beam / 63.0) * kPi / 180.0;
            const double azimuth = (column + 0.5) * 2.0 * kPi / 1900.0;
            const auto dx = static_cast<float>(std::cos(elevation) * std::cos(azimuth));
            const auto dy = static_cast<float>(std::cos(elevation) * std::sin(azimuth));
            const auto dz = static_cast<float>(std::sin(elevation));
            const float range = firstHit(blocks, dx, dy, dz) + noise(random);
            if (range > 120.0F) continue;
            frame.points.x.push_back(range * dx);
            frame.points.y.push_back(range * dy);
            frame.points.z.push_back(range * dz);
        }
    return frame;
}

LadarFrame kittiFrame()
{
    LadarFrame frame;
    const char* data = std::getenv("VDAMF_DATA_DIR");
    if (data == nullptr) return frame;
    const auto file = std::filesystem::path(data) / "2011_09_26" / "2011_09_26_drive_0001_sync" /
                      "velodyne_points" / "data" / "0000000000.bin";
    std::ifstream in(file, std::ios::binary);
    float hit[4];
    while (in.read(reinterpret_cast<char*>(hit), sizeof hit))
    {
        frame.points.x.push_back(hit[0]);
        frame.points.y.push_back(hit[1]);
        frame.points.z.push_back(hit[2]);
    }
    return frame;
}

using Source = LadarFrame (*)();

LadarFrame loaded(benchmark::State& state, Source source)
{
    LadarFrame frame = source();
    if (frame.points.empty())
        state.SkipWithError("set VDAMF_DATA_DIR to a folder with 2011_09_26_drive_0001_sync");
    return frame;
}

void ground(benchmark::State& state, Source source)
{
    const LadarFrame frame = loaded(state, source);
    for (auto _ : state) benchmark::DoNotOptimize(removeGround(frame, {}));
    state.counters["hits"] = static_cast<double>(frame.points.size());
}

void clustering(benchmark::State& state, Source source)
{
    const LadarFrame frame = loaded(state, source);
    const AboveGround above = removeGround(frame, {});
    for (auto _ : state) benchmark::DoNotOptimize(clusterPoints(frame, above, {}));
    state.counters["hits"] = static_cast<double>(above.index.size());
}

void both(benchmark::State& state, Source source)
{
    const LadarFrame frame = loaded(state, source);
    for (auto _ : state)
        benchmark::DoNotOptimize(clusterPoints(frame, removeGround(frame, {}), {}));
    state.counters["hits"] = static_cast<double>(frame.points.size());
}

BENCHMARK_CAPTURE(ground, street, streetFrame)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(clustering, street, streetFrame)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(both, street, streetFrame)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ground, kitti, kittiFrame)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(clustering, kitti, kittiFrame)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(both, kitti, kittiFrame)->Unit(benchmark::kMicrosecond);
}  // namespace

BENCHMARK_MAIN();
