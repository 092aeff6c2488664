// SPDX-License-Identifier: BSD-3-Clause
// tracks.csv: as it is read it can be written again.
#include "memory_file.h"
#include "require.h"
#include "vdamf/evaluation/tables.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    fuzz::mayRefuse(
        [&]
        {
            for (const TrackRow& row : readTracks(file.path()))
                toCsv(FrameResult{row.time, {row.report}, 0, 0, 0, {}});
        });
    return 0;
}
