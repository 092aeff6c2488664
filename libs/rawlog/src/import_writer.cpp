// SPDX-License-Identifier: BSD-3-Clause
#include "import_writer.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

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

ImportWriter::ImportWriter(const ImportOutput& output, std::vector<FilePose> poses,
                           std::filesystem::path posesFile)
    : rawlog_(output.rawlog, writerOptions(output)),
      poses_(std::move(poses)),
      posesFile_(std::move(posesFile))
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
    firstScan_ = std::min(time, firstScan_.value_or(time));
    lastScan_ = std::max(time, lastScan_);
}

void ImportWriter::commit()
{
    checkPosesOfScans();
    writeUntil(std::numeric_limits<double>::infinity());
    rawlog_.commit();
}

void ImportWriter::checkPosesOfScans() const
{
    if (poses_.empty() || !firstScan_) return;
    const double firstPose = *poses_.front().time;
    const double lastPose = *poses_.back().time;
    if (firstPose <= lastScan_ && lastPose >= *firstScan_) return;
    const auto range = [](double first, double last)
    {
        char text[80];
        std::snprintf(text, sizeof text, "%.3f to %.3f s", first, last);
        return std::string(text);
    };
    throw std::runtime_error(posesFile_.string() + ": its poses are at " +
                             range(firstPose, lastPose) + ", the scans at " +
                             range(*firstScan_, lastScan_) +
                             " (UNIX): none of them would have one; do they have one clock?");
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
