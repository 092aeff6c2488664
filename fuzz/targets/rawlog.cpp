// SPDX-License-Identifier: BSD-3-Clause
// A rawlog, plain or gz: read to its end, its scans and poses used.
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "memory_file.h"
#include "require.h"
#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/scan.h"

namespace
{
using namespace vdamf;

void use(const mrpt::obs::CObservation& observation)
{
    durationOf(observation);
    if (!isScan(observation)) return;
    fuzz::mayRefuse(
        [&]
        {
            const auto scan = scanFrom(observation);
            if (!scan) return;
            const PointCloud& points = scan->points;
            fuzz::require(points.y.size() == points.size() && points.z.size() == points.size(),
                          "coordinates are equal in number");
            fuzz::require(points.intensity.empty() || points.intensity.size() == points.size(),
                          "each point has an intensity or none has");
            fuzz::require(points.time.empty() || points.time.size() == points.size(),
                          "each point has a time or none has");
        });
}

void use(const RawlogEntry& entry, InsTrajectory& ins)
{
    if (!entry.object) return;
    ins.insert(*entry.object);
    if (const auto* one = dynamic_cast<const mrpt::obs::CObservation*>(entry.object.get()))
        use(*one);
    if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(entry.object.get()))
        for (const auto& observation : *frame)
            if (observation) use(*observation);
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes = fuzz::textOf(data, size);
    const bool gz = bytes.substr(0, 2) == "\x1f\x8b";
    const fuzz::MemoryFile file(bytes);
    fuzz::mayRefuse(
        [&]
        {
            RawlogReader reader(file.path());
            InsTrajectory ins{InsOptions{}};
            std::string read;
            while (const auto entry = reader.next())
            {
                fuzz::require(!entry->bytes.empty(), "an entry has bytes");
                use(*entry, ins);
                read += entry->bytes;
            }
            ins.at(1.5e9);
            fuzz::require(gz || read == bytes, "no byte of a plain file is lost");
            fuzz::require(read.size() == reader.summary().bytes, "the summary counts all bytes");
        });
    return 0;
}
