// SPDX-License-Identifier: BSD-3-Clause
// Time of one estimate by the number of hits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measurement/methods.h"

namespace vdamf
{
struct TimingRow
{
    std::string method;
    std::vector<double> microseconds;  ///< by number of hits
};

struct Timing
{
    std::vector<int> hits;
    std::vector<TimingRow> rows;
    std::string processor;  ///< that it ran on, as it names itself; empty where it does not
};

/// Mean time (us) of estimating all samples one after another, the least of three batches of at
/// least `batchSeconds`.
double microsecondsPerEstimate(const Method& method, const std::vector<LabelledCluster>& samples,
                               double batchSeconds);

/// Two faces of a car with exactly this many hits, 3 cm off; 8 samples a number.
Timing timed(const std::vector<Method>& methods, const std::vector<int>& hits, std::uint64_t seed);

}  // namespace vdamf
