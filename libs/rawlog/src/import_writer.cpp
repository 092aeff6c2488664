// SPDX-License-Identifier: BSD-3-Clause
#include "import_writer.h"

#include <algorithm>
#include <limits>

#include "kitti_observations.h"

namespace vdamf
{
RawlogWriter::Options writerOptions(const ImportOutput& output)
{
    RawlogWriter::Options options;
    options.gzLevel = output.gzLevel;
    options.existing = output.existing;
    return options;
}

ImportWriter::ImportWriter(const ImportOutput& output, std::vector<FilePose> poses)
    : rawlog_(output.rawlog, writerOptions(output)), poses_(std::move(poses))
{
}

void ImportWriter::add(double time, const mrpt::obs::CObservation& observation)
{
    waiting_.emplace_back(time, serialized(observation));
}

void ImportWriter::write(double time, const mrpt::obs::CObservation& scan)
{
    writeUntil(time);
    rawlog_.write(scan);
}

void ImportWriter::commit()
{
    writeUntil(std::numeric_limits<double>::infinity());
    rawlog_.commit();
}

void ImportWriter::writeUntil(double time)
{
    const auto writePoses = [this](double until)
    {
        for (; nextPose_ < poses_.size() && *poses_[nextPose_].time <= until; ++nextPose_)
        {
            const FilePose& pose = poses_[nextPose_];
            rawlog_.write(poseObservation(pose.pose, mrpt::Clock::fromDouble(*pose.time)));
        }
    };
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    auto next = waiting_.begin();
    for (; next != waiting_.end() && next->first <= time; ++next)
    {
        writePoses(next->first);
        rawlog_.writeBytes(next->second);
    }
    waiting_.erase(waiting_.begin(), next);
    writePoses(time);
}

}  // namespace vdamf
