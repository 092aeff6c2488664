// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/kitti_import.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "kitti_observations.h"
#include "vdamf/rawlog/kitti_truth.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

RawlogWriter::Options writerOptions(const KittiImport& job)
{
    RawlogWriter::Options options;
    options.gzLevel = job.gzLevel;
    options.existing = job.existing;
    return options;
}

std::vector<KittiTracklet> trackletsOf(const KittiDrive& drive)
{
    const fs::path path = drive.folder / "tracklet_labels.xml";
    if (!fs::exists(path))
    {
        throw std::runtime_error(path.string() +
                                 ": is missing, but the truth is asked for; unpack the drive's"
                                 " tracklets, or import without truth");
    }
    return readKittiTracklets(path, drive.scans.size());
}

class KittiImporter
{
public:
    // The outputs are opened first: better to fail at once than after the last scan.
    explicit KittiImporter(const KittiImport& job)
        : job_(job), rawlog_(job.rawlog, writerOptions(job))
    {
        if (job.truth) truth_.emplace(*job.truth, job.existing, OutputFile::Unfinished::Discard);
        drive_ = readKittiDrive(job.drive);
        poses_ = kittiPoses(drive_.oxts);
        if (job.truth) takeLabels(trackletsOf(drive_));
        summary_.poses = poses_.size();
        summary_.missingScans = static_cast<std::size_t>(
            std::count_if(drive_.scans.begin(), drive_.scans.end(),
                          [](const KittiFile& scan) { return !scan.isThere; }));
        summary_.seconds = mrpt::Clock::toDouble(drive_.scans.back().time) -
                           mrpt::Clock::toDouble(drive_.scans.front().time);
    }

    KittiImportSummary run()
    {
        for (std::size_t frame = 0; frame < drive_.scans.size(); ++frame)
        {
            if (drive_.scans[frame].isThere) writeFrame(frame);
            summary_.stopped = job_.progress && !job_.progress(frame + 1, drive_.scans.size());
            if (summary_.stopped) return summary_;
        }
        writePosesUpTo(mrpt::Clock::time_point::max());
        if (truth_) truth_->write(truthTable());
        rawlog_.commit();
        if (truth_) truth_->commit();
        return summary_;
    }

private:
    void takeLabels(const std::vector<KittiTracklet>& tracklets)
    {
        // What a reader of the rawlog will make of the poses.
        InsTrajectory trajectory{InsOptions{}};
        for (std::size_t i = 0; i < poses_.size(); ++i)
        {
            trajectory.insert(poseObservation(poses_[i], drive_.oxts[i].time));
        }
        labels_ = kittiLabels(drive_, tracklets, trajectory);
        summary_.objects = tracklets.size();
        std::size_t all = 0;
        for (const KittiTracklet& tracklet : tracklets) all += tracklet.poses.size();
        summary_.labelsWithoutPose = all - labels_.size();
        const auto hasNoScan = [this](const KittiLabel& label)
        { return !drive_.scans[label.frame].isThere; };
        labels_.erase(std::remove_if(labels_.begin(), labels_.end(), hasNoScan), labels_.end());
        summary_.labels = labels_.size();
    }

    void writePosesUpTo(mrpt::Clock::time_point time)
    {
        for (; nextPose_ < poses_.size() && drive_.oxts[nextPose_].time <= time; ++nextPose_)
        {
            rawlog_.write(poseObservation(poses_[nextPose_], drive_.oxts[nextPose_].time));
            rawlog_.write(gpsObservation(drive_.oxts[nextPose_]));
        }
    }

    void writeFrame(std::size_t frame)
    {
        const KittiFile& file = drive_.scans[frame];
        const PointCloud scan = readKittiScan(file.path);
        writePosesUpTo(file.time);
        rawlog_.write(scanObservation(scan, drive_.velodyneInVehicle, file.time));
        ++summary_.scans;
        summary_.points += scan.size();
        for (; nextLabel_ < labels_.size() && labels_[nextLabel_].frame == frame; ++nextLabel_)
        {
            labels_[nextLabel_].truth.points = pointsInside(labels_[nextLabel_], scan);
        }
    }

    std::string truthTable() const
    {
        std::string table = truthHeader();
        for (const KittiLabel& label : labels_) table += toCsv(label.truth);
        return table;
    }

    const KittiImport& job_;
    RawlogWriter rawlog_;
    std::optional<OutputFile> truth_;
    KittiDrive drive_;
    std::vector<Eigen::Isometry3d> poses_;
    std::vector<KittiLabel> labels_;
    std::size_t nextPose_ = 0;
    std::size_t nextLabel_ = 0;
    KittiImportSummary summary_;
};
}  // namespace

void checkPaths(const KittiImport& job)
{
    std::vector<fs::path> outputs{job.rawlog};
    if (job.truth) outputs.push_back(*job.truth);
    std::vector<NamedInput> inputs = {
        {job.drive / "tracklet_labels.xml", "the drive's labels"},
        {job.drive / "oxts" / "timestamps.txt", "the drive's times"},
        {job.drive / "velodyne_points" / "timestamps.txt", "the drive's times"}};
    const fs::path day = fs::weakly_canonical(job.drive).parent_path();
    for (const fs::path& folder : {job.drive, day})
        for (const char* name :
             {"calib_imu_to_velo.txt", "calib_velo_to_cam.txt", "calib_cam_to_cam.txt"})
            inputs.push_back({folder / name, "the drive's calibration"});
    for (const fs::path& output : outputs)
        for (const auto& [folder, ending, name] :
             {std::tuple(job.drive / "velodyne_points" / "data", ".bin", "a scan of the drive"),
              std::tuple(job.drive / "oxts" / "data", ".txt", "a pose of the drive")})
            if (output.extension() == ending) inputs.push_back({folder / output.filename(), name});
    checkOutputPaths(outputs, inputs);
}

KittiImportSummary importKittiDrive(const KittiImport& job)
{
    checkPaths(job);
    return KittiImporter(job).run();
}

}  // namespace vdamf
