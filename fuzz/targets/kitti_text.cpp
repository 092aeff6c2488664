// SPDX-License-Identifier: BSD-3-Clause
// The text and point files of a KITTI drive: the first byte chooses which.
#include "kitti_numbers.h"
#include "memory_file.h"
#include "require.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/kitti_drive.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    if (size == 0) return 0;
    const fuzz::MemoryFile file(fuzz::textOf(data + 1, size - 1));
    fuzz::mayRefuse(
        [&]
        {
            constexpr std::size_t kOxtsNumbers = 30;
            switch (data[0])
            {
                case 't':
                    readKittiTimestamps(file.path());
                    return;
                case 'c':
                    readRigidTransform(file.path());
                    return;
                case 'o':
                    numbersOf(readTextFile(file.path()), "oxts", kOxtsNumbers);
                    return;
                default:
                    readKittiScan(file.path());
            }
        });
    return 0;
}
