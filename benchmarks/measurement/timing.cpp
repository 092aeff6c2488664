// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/timing.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>

#include "vdamf/simulation/random_stream.h"

namespace vdamf
{
namespace
{
// Of this thread on a processor: other programs take no part in it.
double secondsNow()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string processorName()
{
    std::ifstream file("/proc/cpuinfo");
    const std::string key = "model name";
    for (std::string line; std::getline(file, line);)
    {
        const std::size_t colon = line.find(": ");
        if (line.rfind(key, 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "";
}

// The car stands 15 m ahead, turned by 20 to 70 degrees, its rear and right side in view.
LabelledCluster twoFaces(int hits, std::uint64_t seed, std::uint64_t index)
{
    constexpr double kOff = 0.03;  // m
    RandomStream random(seed, index);
    LabelledCluster sample;
    sample.isBody = false;
    sample.rangeNoise = kOff;
    sample.truth = {15.0, 0.0, -(20.0 + 50.0 * random.uniform()) * kPi / 180.0, 4.5, 1.8};
    const double l = 0.5 * sample.truth.length;
    const double w = 0.5 * sample.truth.width;
    for (int i = 0; i < hits; ++i)
    {
        const double along = random.uniform() * (2.0 * l + 2.0 * w);
        const Eigen::Vector2d onFace = along < 2.0 * l ? Eigen::Vector2d(along - l, -w)
                                                       : Eigen::Vector2d(-l, along - 2.0 * l - w);
        const Eigen::Vector2d off(kOff * random.gaussian(), kOff * random.gaussian());
        const Eigen::Vector2d p =
            sample.truth.centre() + rotation(sample.truth.heading) * (onFace + off);
        sample.cluster.x.push_back(static_cast<float>(p.x()));
        sample.cluster.y.push_back(static_cast<float>(p.y()));
        sample.cluster.z.push_back(1.0F);
        sample.cluster.height.push_back(1.0F);
    }
    sample.start = perturbed(sample.truth, seed, index + 1);
    return sample;
}
}  // namespace

double microsecondsPerEstimate(const Method& method, const std::vector<LabelledCluster>& samples,
                               double batchSeconds)
{
    if (samples.empty()) return 0.0;
    double least = 1e300;
    double sink = 0.0;
    for (int batch = 0; batch < 3; ++batch)
    {
        const double begin = secondsNow();
        double end = begin;
        double estimates = 0.0;
        do
        {
            for (const LabelledCluster& sample : samples) sink += method.estimate(sample).box.x;
            estimates += static_cast<double>(samples.size());
            end = secondsNow();
        } while (end - begin < batchSeconds);
        least = std::min(least, (end - begin) / estimates);
    }
    // The sum is used, so that no estimate is optimised away.
    return std::isnan(sink) ? sink : 1e6 * least;
}

Timing timed(const std::vector<Method>& methods, const std::vector<int>& hits, std::uint64_t seed)
{
    constexpr std::uint64_t kSamples = 8;
    constexpr double kBatchSeconds = 0.03;
    Timing timing{hits, {}, processorName()};
    for (const Method& method : methods)
    {
        TimingRow row{method.name, {}};
        for (const int count : hits)
        {
            std::vector<LabelledCluster> samples;
            for (std::uint64_t k = 0; k < kSamples; ++k)
                samples.push_back(twoFaces(count, seed, 2 * k));
            row.microseconds.push_back(microsecondsPerEstimate(method, samples, kBatchSeconds));
        }
        timing.rows.push_back(row);
    }
    return timing;
}

}  // namespace vdamf
