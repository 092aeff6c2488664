// SPDX-License-Identifier: BSD-3-Clause
#include "range_camera.h"

#include <mrpt/maps/CSimplePointsMap.h>

#include <cstring>
#include <stdexcept>

#include "vdamf/rawlog/allocation_limit.h"

namespace vdamf
{
namespace
{
using Camera = mrpt::obs::CObservation3DRangeScan;

/// MRPT copies flags from the file as they are: in a damaged one they may be no bool at all, and
/// nothing may look at them, not even a copy.
class CameraFlags : public Camera
{
public:
    static bool areBools(const Camera& scan)
    {
        for (const auto flag :
             {&Camera::hasPoints3D, &Camera::hasRangeImage, &Camera::range_is_depth,
              &Camera::hasIntensityImage, &Camera::hasConfidenceImage,
              &CameraFlags::m_points3D_external_stored, &CameraFlags::m_rangeImage_external_stored})
        {
            unsigned char byte = 0;
            std::memcpy(&byte, &(scan.*flag), sizeof byte);
            if (byte > 1) return false;
        }
        return true;
    }
};

/// Loading and projecting change the object: a copy, with all that is in external files.
class LoadedCamera : public Camera
{
public:
    LoadedCamera(const Camera& scan, const ExternalFiles& files) : Camera(scan)
    {
        if (m_points3D_external_stored)
            m_points3D_external_file = files.find(m_points3D_external_file).string();
        if (m_rangeImage_external_stored)
            m_rangeImage_external_file = files.find(m_rangeImage_external_file).string();
        const AllocationLimit limit(ExternalFiles::kLargestAllocation);
        load();
    }
};
}  // namespace

PointCloud hitsOf(const Camera& scan, const ExternalFiles& files)
{
    if (!CameraFlags::areBools(scan)) throw std::runtime_error("its flags are damaged");
    LoadedCamera copy(scan, files);
    PointCloud cloud;
    if (copy.hasPoints3D)
    {
        cloud.x.assign(copy.points3D_x.begin(), copy.points3D_x.end());
        cloud.y.assign(copy.points3D_y.begin(), copy.points3D_y.end());
        cloud.z.assign(copy.points3D_z.begin(), copy.points3D_z.end());
        if (cloud.y.size() != cloud.size() || cloud.z.size() != cloud.size())
            throw std::runtime_error("the coordinates of its points differ in number");
        return cloud;
    }
    if (!copy.hasRangeImage) throw std::runtime_error("it has no points and no range image");
    mrpt::maps::CSimplePointsMap map;
    copy.unprojectInto(map);
    cloud.x.assign(map.getPointsBufferRef_x().begin(), map.getPointsBufferRef_x().end());
    cloud.y.assign(map.getPointsBufferRef_y().begin(), map.getPointsBufferRef_y().end());
    cloud.z.assign(map.getPointsBufferRef_z().begin(), map.getPointsBufferRef_z().end());
    return cloud;
}

}  // namespace vdamf
