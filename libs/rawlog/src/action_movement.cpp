// SPDX-License-Identifier: BSD-3-Clause
#include "action_movement.h"

#include <mrpt/core/Clock.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "object_header.h"
#include "vdamf/rawlog/allocation_limit.h"

namespace vdamf
{
namespace
{
using mrpt::poses::CPose3D;
using mrpt::serialization::CArchive;

constexpr std::size_t kLargestOfAction = 1 << 20;
constexpr std::uint32_t kByOdometry = 0;

void skipBytes(CArchive& in, std::size_t count)
{
    std::array<std::uint8_t, 64> room = {};
    if (count > room.size()) throw std::logic_error("skips more than there is room for");
    in.ReadBuffer(room.data(), count);
}

/// Numbers of the motion models: a selection, those of the Gaussian one, the count of particles,
/// those of the other one.
std::size_t modelBytes(int version)
{
    constexpr std::size_t kNumber = 4;
    if (version == 2) return 44;
    const std::size_t gaussian = version == 3 ? 5 : 6;
    const std::size_t particles = version >= 5 ? 6 : 4;
    return kNumber * (1 + gaussian + 1 + particles);
}

std::optional<double> timeIn(CArchive& in)
{
    mrpt::Clock::time_point stamp;
    in >> stamp;
    if (stamp == INVALID_TIMESTAMP) return std::nullopt;
    return mrpt::Clock::toDouble(stamp);
}

struct Change
{
    CPose3D pose;
    std::optional<double> time;
};

/// Of the vehicle, and ticks of its encoders: from version 7 on only where there are any.
void skipVelocities(CArchive& in, int version)
{
    constexpr std::size_t kTicks = 4 + 4;
    const std::size_t velocities = version >= 7 ? 3 * 8 : 2 * 4;
    const bool hasVelocities = in.ReadAs<std::uint8_t>() != 0;
    if (hasVelocities || version < 7) skipBytes(in, velocities);
    const bool hasTicks = in.ReadAs<std::uint8_t>() != 0;
    if (hasTicks || version < 7) skipBytes(in, kTicks);
}

Change planar(CArchive& in, int version)
{
    Change change;
    if (in.ReadAs<std::uint32_t>() == kByOdometry)
    {
        mrpt::poses::CPose2D increment;
        in >> increment;
        change.pose = CPose3D(increment);
        skipBytes(in, modelBytes(version));
    }
    else
    {
        mrpt::poses::CPosePDFGaussian pdf;
        in >> pdf;
        change.pose = CPose3D(pdf.mean);
    }
    skipVelocities(in, version);
    if (version >= 6) change.time = timeIn(in);
    return change;
}

Change spatial(CArchive& in, int version)
{
    Change change;
    in.ReadAs<std::uint32_t>();
    mrpt::poses::CPose3DPDFGaussian pdf;
    in >> pdf;
    change.pose = pdf.mean;
    constexpr std::uint32_t kVelocities = 6;
    if (version < 1 || in.ReadAs<std::uint32_t>() != kVelocities) return change;
    skipBytes(in, kVelocities);
    if (in.ReadAs<std::uint32_t>() != kVelocities) return change;
    skipBytes(in, kVelocities * 4);
    change.time = timeIn(in);
    return change;
}

std::optional<Change> changeIn(std::string_view bytes)
{
    const auto header = parseObjectHeader(bytes);
    if (!header || header->bytes >= bytes.size()) return std::nullopt;
    mrpt::io::CMemoryStream stream;
    stream.assignMemoryNotOwn(bytes.data() + header->bytes, bytes.size() - header->bytes);
    auto in = mrpt::serialization::archiveFrom(stream);
    const std::string name = header->className.substr(header->className.rfind(':') + 1);
    if (name == "CActionRobotMovement2D" && header->version >= 2 && header->version <= 7)
        return planar(in, header->version);
    if (name == "CActionRobotMovement3D" && header->version <= 1)
        return spatial(in, header->version);
    return std::nullopt;
}

/// The first action of a collection; other actions as they are.
std::string_view firstAction(std::string_view bytes)
{
    constexpr std::size_t kCountBytes = 4;
    const auto header = parseObjectHeader(bytes);
    if (!header || !isActionCollection(header->className)) return bytes;
    return bytes.substr(std::min(bytes.size(), header->bytes + kCountBytes));
}
}  // namespace

std::optional<VehicleMovement> movementOf(std::string_view bytes)
{
    constexpr double kLongestStep = 1000.0;  // m
    try
    {
        const AllocationLimit limit(kLargestOfAction);
        const std::optional<Change> change = changeIn(firstAction(bytes));
        if (!change) return std::nullopt;
        VehicleMovement movement;
        movement.time = change->time;
        movement.change.linear() = change->pose.getRotationMatrix().asEigen();
        movement.change.translation() =
            Eigen::Vector3d(change->pose.x(), change->pose.y(), change->pose.z());
        const bool possible = movement.change.matrix().allFinite() &&
                              movement.change.translation().norm() < kLongestStep;
        return possible ? std::optional(movement) : std::nullopt;
    }
    catch (const std::exception&)
    {
        return std::nullopt;
    }
}

}  // namespace vdamf
