// SPDX-License-Identifier: BSD-3-Clause
// Watches the frames of an endurance run.
#pragma once

#include <ctime>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "endurance/endurance.h"
#include "endurance/rounds.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf::endurance
{
class Monitor
{
public:
    Monitor(const Plan& plan, const Rounds& rounds, std::function<void(const Row&)> onRow);

    void add(const FrameResult& frame);
    Result result();

private:
    using Places = std::vector<std::pair<double, double>>;

    void compare(const FrameResult& frame);
    void noteIdentities(const FrameResult& frame);
    void endRow(double time);

    const Plan& plan_;
    const Rounds& rounds_;
    std::function<void(const Row&)> onRow_;
    Result result_;
    Row row_;
    std::uint64_t round_ = 0;
    std::map<double, Places> first_;  ///< where tracks were in the first round, by its ms
    /// Tracks of this row, and those near one of the first round.
    std::uint64_t compared_ = 0;
    std::uint64_t same_ = 0;
    std::uint64_t alike_ = 0;
    std::uint64_t newestBefore_ = 0;  ///< identity before this round
    std::uint64_t newest_ = 0;
    std::set<std::uint64_t> living_;
    std::set<std::uint64_t> confirmed_;  ///< of the living
    std::clock_t begin_;
};

}  // namespace vdamf::endurance
