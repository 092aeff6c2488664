// SPDX-License-Identifier: BSD-3-Clause
// How things stand on the ground.
#include "vdamf/simulation/ground_pose.h"

#include <Eigen/Geometry>
#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
Eigen::Matrix3d attitudeOf(double yaw, double pitch, double roll)
{
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    return (AngleAxisd(yaw, Vector3d::UnitZ()) * AngleAxisd(pitch, Vector3d::UnitY()) *
            AngleAxisd(roll, Vector3d::UnitX()))
        .toRotationMatrix();
}

Eigen::Matrix3d GroundPose::attitude() const
{
    return attitudeOf(heading, pitch, roll);
}

GroundPose standOn(const Terrain& terrain, const Eigen::Vector2d& place, double heading,
                   const Contacts& contacts)
{
    GroundPose pose;
    pose.heading = heading;
    pose.position << place, 0.0;
    if (terrain.isFlat()) return pose;
    const double length = contacts.front + contacts.rear;
    if (length <= 0.0 || contacts.half <= 0.0)
    {
        pose.position.z() = terrain.height(place);
        return pose;
    }
    const Eigen::Matrix2d turn = rotation(heading);
    const auto heightAt = [&](double x, double y)
    { return terrain.height(place + turn * Eigen::Vector2d(x, y)); };
    const double frontLeft = heightAt(contacts.front, contacts.half);
    const double frontRight = heightAt(contacts.front, -contacts.half);
    const double rearLeft = heightAt(-contacts.rear, contacts.half);
    const double rearRight = heightAt(-contacts.rear, -contacts.half);
    const double front = 0.5 * (frontLeft + frontRight);
    const double rear = 0.5 * (rearLeft + rearRight);
    const double left = 0.5 * (frontLeft + rearLeft);
    const double right = 0.5 * (frontRight + rearRight);
    const double rise = (front - rear) / length;                     // dz/dx
    const double leftRise = (left - right) / (2.0 * contacts.half);  // dz/dy
    pose.position.z() = rear + rise * contacts.rear;
    pose.pitch = -std::atan(rise);
    pose.roll = std::atan(leftRise * std::cos(pose.pitch));
    return pose;
}

}  // namespace vdamf
