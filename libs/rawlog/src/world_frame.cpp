// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/world_frame.h"

#include <cmath>

#include "scan_path.h"

namespace vdamf
{
namespace
{
/// The frame of a scan, with room for its hits.
LadarFrame emptyFrame(const Scan& scan, const VehiclePose& pose)
{
    LadarFrame frame;
    frame.time = scan.time;
    // The vehicle itself: where it is in the world is in none of the hits' numbers.
    frame.origin = onGrid(pose.position);
    frame.sensor = frame.origin + onGrid(pose.attitude * scan.sensorInVehicle);
    frame.planar = scan.planar;
    frame.points.intensity = scan.points.intensity;
    frame.points.time = scan.points.time;
    for (float& time : frame.points.time)
        if (std::isfinite(time) && !ScanPath::isPlausible(time)) time = 0.0F;
    for (auto* values : {&frame.points.x, &frame.points.y, &frame.points.z})
        values->resize(scan.points.size());
    return frame;
}

/// Moves the hits from `begin` to `end` as one.
void move(const PointCloud& in, std::size_t begin, std::size_t end, const VehicleInFrame& vehicle,
          PointCloud& out)
{
    const Eigen::Matrix3f r = vehicle.rotation;
    const Eigen::Vector3f t = vehicle.translation;
    const float* const x = in.x.data();
    const float* const y = in.y.data();
    const float* const z = in.z.data();
    float* const outX = out.x.data();
    float* const outY = out.y.data();
    float* const outZ = out.z.data();
    for (std::size_t i = begin; i < end; ++i)
    {
        outX[i] = r(0, 0) * x[i] + r(0, 1) * y[i] + r(0, 2) * z[i] + t.x();
        outY[i] = r(1, 0) * x[i] + r(1, 1) * y[i] + r(1, 2) * z[i] + t.y();
        outZ[i] = r(2, 0) * x[i] + r(2, 1) * y[i] + r(2, 2) * z[i] + t.z();
    }
}

template <class Values>
void append(Values& to, const Values& more)
{
    to.insert(to.end(), more.begin(), more.end());
}

std::vector<float> timesOf(const LadarFrame& frame, double since)
{
    const auto offset = static_cast<float>(frame.time - since);
    std::vector<float> times = frame.points.time;
    if (times.empty()) times.resize(frame.points.size());
    for (float& time : times) time += offset;
    return times;
}
}  // namespace

LadarFrame toLadarFrame(const Scan& scan, const VehiclePose& pose)
{
    LadarFrame frame = emptyFrame(scan, pose);
    move(scan.points, 0, scan.points.size(), vehicleInFrame(pose, frame.origin), frame.points);
    return frame;
}

DeskewedFrame toLadarFrame(const Scan& scan, const VehiclePose& pose, const InsTrajectory& ins)
{
    const std::vector<float>& times = scan.points.time;
    if (times.empty()) return {toLadarFrame(scan, pose), true};
    DeskewedFrame result{emptyFrame(scan, pose), true};
    const ScanPath path(times, pose, ins, result.frame.origin);
    result.posesCoverScan = path.isComplete();
    // Hits come in the order of their times, many at a step: runs of them are moved as one.
    for (std::size_t begin = 0, end = 0; begin < times.size(); begin = end)
    {
        const int step = ScanPath::stepOf(times[begin]);
        while (end < times.size() && ScanPath::stepOf(times[end]) == step) ++end;
        move(scan.points, begin, end, path.at(step), result.frame.points);
    }
    return result;
}

LadarFrame merged(LadarFrame first, const LadarFrame& second)
{
    PointCloud& points = first.points;
    const PointCloud& more = second.points;
    if (points.intensity.empty() || more.intensity.empty())
        points.intensity.clear();
    else
        append(points.intensity, more.intensity);
    // Also where neither has times: all hits of a scan then belong to its own.
    points.time = timesOf(first, first.time);
    append(points.time, timesOf(second, first.time));
    append(points.x, more.x);
    append(points.y, more.y);
    append(points.z, more.z);
    const Eigen::Vector3f shift = (second.origin - first.origin).cast<float>();
    for (std::size_t i = points.size() - more.size(); i < points.size(); ++i)
    {
        points.x[i] += shift.x();
        points.y[i] += shift.y();
        points.z[i] += shift.z();
    }
    first.planar = first.planar && second.planar;
    return first;
}

LadarFrame movedBy(LadarFrame frame, const PlaneMotion& motion)
{
    const PlaneMotion there = motion.about(frame.origin.head<2>());
    const Eigen::Matrix2f turn = rotation(there.turn).cast<float>();
    const Eigen::Vector2f shift = there.shift.cast<float>();
    for (std::size_t i = 0; i < frame.points.size(); ++i)
    {
        const Eigen::Vector2f p =
            turn * Eigen::Vector2f(frame.points.x[i], frame.points.y[i]) + shift;
        frame.points.x[i] = p.x();
        frame.points.y[i] = p.y();
    }
    frame.sensor.head<2>() = motion.of(Eigen::Vector2d(frame.sensor.head<2>()));
    return frame;
}

}  // namespace vdamf
