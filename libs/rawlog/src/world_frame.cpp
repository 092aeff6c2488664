// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/world_frame.h"

namespace vdamf
{
LadarFrame toLadarFrame(const Scan& scan, const VehiclePose& pose)
{
    LadarFrame frame;
    frame.time = scan.time;
    frame.sensor = pose.position + pose.attitude * scan.sensorInVehicle;
    // Whole metres are exact in single and double precision alike.
    frame.origin = pose.position.array().round();
    const Eigen::Matrix3f r = pose.attitude.toRotationMatrix().cast<float>();
    const Eigen::Vector3f t = (pose.position - frame.origin).cast<float>();
    const PointCloud& in = scan.points;
    const std::size_t n = in.size();
    PointCloud& out = frame.points;
    out.intensity = in.intensity;
    out.time = in.time;
    out.x.resize(n);
    out.y.resize(n);
    out.z.resize(n);
    const float* x = in.x.data();
    const float* y = in.y.data();
    const float* z = in.z.data();
    for (std::size_t i = 0; i < n; ++i)
    {
        out.x[i] = r(0, 0) * x[i] + r(0, 1) * y[i] + r(0, 2) * z[i] + t.x();
        out.y[i] = r(1, 0) * x[i] + r(1, 1) * y[i] + r(1, 2) * z[i] + t.y();
        out.z[i] = r(2, 0) * x[i] + r(2, 1) * y[i] + r(2, 2) * z[i] + t.z();
    }
    return frame;
}

}  // namespace vdamf
