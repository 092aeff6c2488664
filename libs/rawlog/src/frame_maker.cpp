// SPDX-License-Identifier: BSD-3-Clause
#include "frame_maker.h"

#include <utility>

namespace vdamf
{
std::optional<LadarFrame> FrameMaker::frameOf(const PendingScan& scan,
                                              const std::optional<VehiclePose>& pose,
                                              const std::vector<PendingScan*>& partners)
{
    if (summary_.frames > 0 && scan.time <= summary_.lastTime)
    {
        ++(scan.time == summary_.lastTime ? summary_.atOneTime : summary_.outOfOrder);
        return std::nullopt;
    }
    std::optional<LadarFrame> frame = frameOf(scan, pose);
    if (!frame) return std::nullopt;
    for (const PendingScan* partner : partners)
    {
        const auto other = frameOf(*partner, ins_.at(partner->time));
        if (!other) continue;
        frame = merged(std::move(*frame), *other);
        ++summary_.merged;
    }
    return frame;
}

std::optional<LadarFrame> FrameMaker::frameOf(const PendingScan& scan,
                                              const std::optional<VehiclePose>& pose)
{
    if (!pose)
    {
        ++summary_.withoutPose;
        return std::nullopt;
    }
    try
    {
        const Scan hits = *scanFrom(*scan.observation, files_);
        if (hits.points.empty()) ++summary_.withoutHits;
        if (!options_.deskew) return toLadarFrame(hits, *pose);
        DeskewedFrame deskewed = toLadarFrame(hits, *pose, ins_);
        if (!deskewed.posesCoverScan) ++summary_.partlyDeskewed;
        return std::move(deskewed.frame);
    }
    catch (const std::exception& error)
    {
        if (summary_.unreadable++ == 0) summary_.firstUnreadable = error.what();
        return std::nullopt;
    }
}

}  // namespace vdamf
