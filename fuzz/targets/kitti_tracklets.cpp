// SPDX-License-Identifier: BSD-3-Clause
// tracklet_labels.xml of a KITTI drive.
#include "vdamf/rawlog/kitti_tracklets.h"
#include "memory_file.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    constexpr std::size_t kFrames = 100;
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    fuzz::mayRefuse(
        [&]
        {
            for (const KittiTracklet& tracklet : readKittiTracklets(file.path(), kFrames))
                fuzz::require(tracklet.firstFrame + tracklet.poses.size() <= kFrames,
                              "a tracklet is within the drive");
        });
    return 0;
}
