// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/run_scene.h"

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>

#include <algorithm>
#include <cmath>

#include "track_shapes.h"
#include "vdamf/files/gz_member.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf
{
namespace
{
mrpt::opengl::CRenderizable::Ptr lineOf(const std::vector<Eigen::Vector3f>& places,
                                        const mrpt::img::TColor& colour, float width)
{
    auto line = mrpt::opengl::CSetOfLines::Create();
    for (std::size_t i = 1; i < places.size(); ++i)
    {
        const Eigen::Vector3f& a = places[i - 1];
        const Eigen::Vector3f& b = places[i];
        line->appendLine(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
    }
    line->setColor_u8(colour);
    line->setLineWidth(width);
    return line;
}

/// Blue on the ground, through green to red at the height of the sensor and above.
mrpt::opengl::CRenderizable::Ptr hitsOf(const LadarFrame& frame)
{
    constexpr double kSpan = 2.5;  // m below the sensor
    auto cloud = mrpt::opengl::CPointCloudColoured::Create();
    for (std::size_t i = 0; i < frame.points.size(); ++i)
    {
        const Eigen::Vector3d p =
            frame.origin + Eigen::Vector3d(frame.points.x[i], frame.points.y[i], frame.points.z[i]);
        if (!p.allFinite()) continue;
        const double share = std::clamp(1.0 + (p.z() - frame.sensor.z()) / kSpan, 0.0, 1.0);
        const auto channel = [share](double peak)
        { return static_cast<float>(std::clamp(1.5 - 3.0 * std::abs(share - peak), 0.0, 1.0)); };
        cloud->push_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                         static_cast<float>(p.z()), channel(1.0), channel(0.5), channel(0.0));
    }
    cloud->setPointSize(2.0F);
    return cloud;
}

mrpt::opengl::CRenderizable::Ptr sensorOf(const Eigen::Vector3d& place)
{
    auto point = mrpt::opengl::CPointCloud::Create();
    point->insertPoint(static_cast<float>(place.x()), static_cast<float>(place.y()),
                       static_cast<float>(place.z()));
    point->setPointSize(8.0F);
    point->setColor_u8(mrpt::img::TColor::white());
    return point;
}
}  // namespace

void RunScene::add(const LadarFrame& frame, const FrameResult& result)
{
    frame_ = frame;
    sensor_.emplace_back(frame.sensor.cast<float>());
    for (auto& [id, path] : paths_) path.isThere = false;
    for (const TrackReport& track : result.tracks)
    {
        if (!isPublished(track)) continue;
        Path& path = paths_[track.id];
        path.places.emplace_back(Eigen::Vector3d(track.box.x, track.box.y, track.z).cast<float>());
        path.last = track;
        path.isThere = true;
    }
}

std::string RunScene::bytes() const
{
    constexpr int kGzLevel = 6;
    mrpt::opengl::COpenGLScene scene;
    scene.insert(hitsOf(frame_));
    scene.insert(lineOf(sensor_, mrpt::img::TColor::white(), 3.0F));
    scene.insert(sensorOf(frame_.sensor));
    for (const auto& [id, path] : paths_)
    {
        scene.insert(lineOf(path.places, colourOf(path.last), 1.5F));
        if (!path.isThere) continue;
        scene.insert(boxOf(path.last));
        scene.insert(headingLine(path.last));
        scene.insert(nameOf(path.last));
    }
    return gzMember(serialized(scene), kGzLevel);
}

}  // namespace vdamf
