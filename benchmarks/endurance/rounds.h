// SPDX-License-Identifier: BSD-3-Clause
// The drive of a rawlog, again and again, later and farther away each time.
#pragma once

#include <mrpt/obs/CObservation.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vdamf::endurance
{
class Rounds
{
public:
    /// `pause` (s) lies between two rounds, `drift` (m) is added to x and y of each. Every second
    /// one is a few kilometres aside as well, out of reach for the tracks of the one before.
    Rounds(const std::filesystem::path& rawlog, double pause, double drift);

    /// The bytes of the next round; the first one is as in the rawlog.
    std::string next();

    double begin() const { return begin_; }    ///< of the first round, s (UNIX)
    double period() const { return period_; }  ///< from one begin to the next, s
    /// By how much a round is moved, m.
    double eastOf(std::uint64_t round) const;
    double northOf(std::uint64_t round) const;

private:
    std::vector<mrpt::obs::CObservation::Ptr> observations_;
    double begin_ = 0.0;
    double period_ = 0.0;
    double drift_ = 0.0;
    std::uint64_t round_ = 0;  ///< to come
};

}  // namespace vdamf::endurance
