// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/cloud_import.h"

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "cloud_times.h"
#include "import_writer.h"
#include "kitti_observations.h"
#include "natural_order.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

/// Names that are numbers as a whole may have a decimal point.
bool nameBefore(const fs::path& a, const fs::path& b)
{
    const auto x = parseNumber(a.stem().string());
    const auto y = parseNumber(b.stem().string());
    if (x && y && *x != *y) return *x < *y;
    if (x.has_value() != y.has_value()) return x.has_value();
    return naturallyBefore(a.filename().string(), b.filename().string());
}

bool isCloud(const fs::path& path)
{
    const std::string ending = path.extension().string();
    return ending == ".pcd" || ending == ".ply" || ending == ".bin" || ending == ".PCD" ||
           ending == ".PLY";
}

std::vector<fs::path> cloudsIn(const fs::path& folder)
{
    std::error_code error;
    std::vector<fs::path> clouds;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (isCloud(it->path())) clouds.push_back(it->path());
    if (error) throw std::runtime_error(folder.string() + ": cannot list: " + error.message());
    if (clouds.empty())
        throw std::runtime_error(folder.string() + ": holds no .pcd, .ply or .bin file");
    std::sort(clouds.begin(), clouds.end(), nameBefore);
    return clouds;
}

std::vector<FilePose> posesOf(const CloudImport& job, std::size_t clouds)
{
    if (job.poses.empty()) return {};
    std::vector<FilePose> poses = readPoseFile(job.poses);
    if (poses.front().time || poses.size() == clouds) return poses;
    throw std::runtime_error(job.poses.string() + ": holds " + std::to_string(poses.size()) +
                             " poses, " + job.folder.string() + " has " + std::to_string(clouds) +
                             " clouds; poses without times must be one for each");
}

/// Times of the hits relative to the cloud's: what stands in the file may count from its begin,
/// from the cloud's time, or from 1970.
std::vector<float> relativeTimes(const std::vector<double>& times, double cloudTime,
                                 const fs::path& file)
{
    constexpr double kLongest = 1.0;  // s
    const auto [least, most] = std::minmax_element(times.begin(), times.end());
    const bool absolute = std::abs(*least - cloudTime) < 10.0 && *least > 1e6;
    const double zero = absolute                                   ? cloudTime
                        : (*least < -kLongest || *most > kLongest) ? *least
                                                                   : 0;
    if (!(*most - *least <= kLongest))
        throw std::runtime_error(file.string() + ": the times of its hits span " +
                                 std::to_string(*most - *least) +
                                 " s; say their unit with --point-time, or leave them with none");
    std::vector<float> relative;
    relative.reserve(times.size());
    for (const double time : times) relative.push_back(static_cast<float>(time - zero));
    return relative;
}

mrpt::obs::CObservation::Ptr withTimes(const PointCloud& points, double cloudTime)
{
    const auto scan = std::make_shared<mrpt::obs::CObservationVelodyneScan>();
    auto& cloud = scan->point_cloud;
    cloud.x = points.x;
    cloud.y = points.y;
    cloud.z = points.z;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const float intensity = points.intensity.empty() ? 0.0F : points.intensity[i];
        cloud.intensity.push_back(static_cast<std::uint8_t>(std::lround(255.0F * intensity)));
        cloud.timestamp.push_back(
            mrpt::Clock::fromDouble(cloudTime + static_cast<double>(points.time[i])));
        cloud.azimuth.push_back(-std::atan2(points.y[i], points.x[i]));
        cloud.laser_id.push_back(0);
    }
    return scan;
}

mrpt::obs::CObservation::Ptr observationOf(const CloudImport& job, PointCloud points, double time)
{
    const auto stamp = mrpt::Clock::fromDouble(time);
    mrpt::obs::CObservation::Ptr observation;
    if (!points.time.empty())
        observation = withTimes(points, time);
    else
    {
        if (points.intensity.empty()) points.intensity.resize(points.size());
        observation = std::make_shared<mrpt::obs::CObservationPointCloud>(
            scanObservation(points, job.sensorInVehicle, stamp));
    }
    observation->timestamp = stamp;
    observation->sensorLabel = job.label;
    observation->setSensorPose(toPose3D(job.sensorInVehicle));
    return observation;
}
}  // namespace

void checkPaths(const CloudImport& job)
{
    const fs::path& output = job.output.rawlog;
    checkOutputPaths({output}, {{job.poses, "the file of poses"},
                                {job.times, "the file of times"},
                                {isCloud(output) ? job.folder / output.filename() : fs::path(),
                                 "one of the clouds"}});
}

CloudImportSummary importClouds(const CloudImport& job)
{
    checkPaths(job);
    const std::vector<fs::path> clouds = cloudsIn(job.folder);
    std::vector<FilePose> poses = posesOf(job, clouds.size());
    const CloudTimes times = cloudTimes(job, clouds, poses);
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (!poses[i].time) poses[i].time = times.seconds[i];
    CloudImportSummary summary;
    summary.times = times.source;
    summary.poses = poses.size();
    summary.seconds = times.seconds.back() - times.seconds.front();
    ImportWriter writer(job.output, std::move(poses), job.poses);
    for (std::size_t i = 0; i < clouds.size(); ++i)
    {
        FileCloud cloud = readCloudFile(clouds[i], job.pointTime);
        if (!cloud.times.empty())
            cloud.points.time = relativeTimes(cloud.times, times.seconds[i], clouds[i]);
        summary.points += cloud.points.size();
        summary.pointsLeftOut += cloud.leftOut;
        summary.pointTimes = summary.pointTimes || !cloud.points.time.empty();
        writer.write(times.seconds[i],
                     *observationOf(job, std::move(cloud.points), times.seconds[i]));
        ++summary.scans;
        const double share = static_cast<double>(i + 1) / static_cast<double>(clouds.size());
        summary.stopped = job.output.progress && !job.output.progress(summary.scans, share);
        if (summary.stopped) return summary;
    }
    writer.commit();
    return summary;
}

}  // namespace vdamf
