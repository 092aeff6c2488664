// SPDX-License-Identifier: BSD-3-Clause
// Files of poses and of times.
#include "memory_file.h"
#include "require.h"
#include "vdamf/rawlog/pose_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    fuzz::mayRefuse(
        [&]
        {
            for (const FilePose& pose : readPoseFile(file.path()))
                fuzz::require(pose.pose.matrix().allFinite(), "a pose is finite");
        });
    fuzz::mayRefuse([&] { readTimeFile(file.path()); });
    return 0;
}
