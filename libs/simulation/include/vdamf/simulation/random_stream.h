// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same with every standard library: the engine's bits are fixed by
// the C++ standard, its distributions are not, so these are our own.
#pragma once

#include <cstdint>
#include <random>

namespace vdamf
{
class RandomStream
{
public:
    /// Streams of one seed with different indices (frames, for example) are unrelated, so that a
    /// frame does not depend on how many numbers the frames before it drew.
    RandomStream(std::uint64_t seed, std::uint64_t index);

    double uniform();                 ///< in [0, 1)
    double gaussian();                ///< zero mean, unit variance
    double exponential(double mean);  ///< >= 0

private:
    std::mt19937_64 engine_;
};

/// The index of a stream for a purpose and a number of use (scans, for example).
constexpr std::uint64_t streamIndex(std::uint64_t purpose, std::uint64_t number)
{
    return (purpose << 40) + number;
}

/// Purposes below it are the sensors of a scenario.
inline constexpr std::uint64_t kInsStream = 1 << 20;

}  // namespace vdamf
