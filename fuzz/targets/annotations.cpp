// SPDX-License-Identifier: BSD-3-Clause
// An annotated rawlog, read back.
#include "memory_file.h"
#include "require.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/annotated_rawlog.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    fuzz::mayRefuse(
        [&]
        {
            const Annotations read = readAnnotations(file.path());
            for (const auto& [stamp, tracks] : read.tables)
                toCsv(FrameResult{0.0, tracks, 0, 0, 0, {}});
            const std::atomic<bool> stop{false};
            replayRawlog(file.path(), read, stop,
                         [](const LadarFrame&, const FrameResult&, double) {});
        });
    return 0;
}
