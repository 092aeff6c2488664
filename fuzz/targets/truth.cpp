// SPDX-License-Identifier: BSD-3-Clause
// truth.csv: as it is read it can be written and read again; also as the traffic of a scene.
#include "memory_file.h"
#include "require.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/simulation/recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    fuzz::mayRefuse([&] { readTruthTable(file.path()); });
    fuzz::mayRefuse(
        [&]
        {
            for (const TruthRow& row : readTruth(file.path())) toCsv(row);
        });
    return 0;
}
