// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/reliability.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
Reliability reliabilityOf(const std::vector<ClassifierSample>& samples, int bins)
{
    std::vector<ReliabilityBin> all(static_cast<std::size_t>(bins));
    Reliability result;
    for (const ClassifierSample& sample : samples)
    {
        const int bin = std::min(bins - 1, static_cast<int>(sample.score * bins));
        ReliabilityBin& in = all[static_cast<std::size_t>(bin)];
        const double outcome = sample.vehicle ? 1.0 : 0.0;
        ++in.samples;
        in.probability += sample.score;
        in.share += outcome;
        result.brierScore += (sample.score - outcome) * (sample.score - outcome);
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, samples.size()));
    result.brierScore /= count;
    for (ReliabilityBin& bin : all)
    {
        if (bin.samples == 0) continue;
        const auto inBin = static_cast<double>(bin.samples);
        bin.probability /= inBin;
        bin.share /= inBin;
        result.expectedCalibrationError += inBin / count * std::abs(bin.share - bin.probability);
        result.bins.push_back(bin);
    }
    return result;
}

}  // namespace vdamf
