// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/annotation.h"

#include <mrpt/obs/CObservation3DScene.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>

#include <stdexcept>

#include "track_shapes.h"
#include "vdamf/rawlog/annotation_table.h"

namespace vdamf
{
namespace
{
bool isLabelOfAnnotations(const std::string& label)
{
    return label.rfind(kAnnotationLabel, 0) == 0;
}
}  // namespace

bool isAnnotation(const mrpt::obs::CObservation& observation)
{
    return isLabelOfAnnotations(observation.sensorLabel);
}

void checkSensorLabel(const std::string& label, const std::string& where)
{
    if (isLabelOfAnnotations(label))
        throw std::runtime_error(where + ": the label '" + label + "' begins with '" +
                                 kAnnotationLabel +
                                 "', as what vdamf-track adds to a rawlog; choose another one");
}

bool isHead(const mrpt::serialization::CSerializable& entry)
{
    const auto* comment = dynamic_cast<const mrpt::obs::CObservationComment*>(&entry);
    return comment != nullptr && comment->text.rfind(kHeadBegin, 0) == 0;
}

bool isScene(const mrpt::obs::CObservation& observation)
{
    return dynamic_cast<const mrpt::obs::CObservation3DScene*>(&observation) != nullptr;
}

mrpt::obs::CObservationComment headComment(const std::string& version, const std::string& origin,
                                           const std::string& insSource,
                                           const Configuration& configuration,
                                           mrpt::Clock::time_point stamp)
{
    std::string columns;
    for (const std::string& c : annotationColumns()) columns += (columns.empty() ? "" : ",") + c;
    mrpt::obs::CObservationComment comment;
    comment.timestamp = stamp;
    comment.text = std::string(kHeadBegin) + "version = " + version +
                   "\nworld = x east, y north, z up\norigin = " + origin + "\nins = " + insSource +
                   "\ntable_label = vdamf_tracks\ntable_columns = " + columns + "\n\n" +
                   toIni(configuration);
    return comment;
}

std::vector<mrpt::obs::CObservation::Ptr> Annotator::annotate(const FrameResult& frame,
                                                              mrpt::Clock::time_point stamp)
{
    std::vector<mrpt::obs::CObservation::Ptr> all;
    if (options_.table) all.push_back(table(frame));
    if (options_.poses)
    {
        for (const TrackReport& track : frame.tracks)
            if (isPublished(track)) all.push_back(pose(track));
    }
    const bool isRead = options_.table || options_.poses || options_.scene;
    if (isRead && !frame.alignment.isNone()) all.push_back(alignment(frame.alignment));
    if (options_.scene)
    {
        extendTrails(frame);
        all.push_back(scene(frame));
    }
    for (const auto& observation : all) observation->timestamp = stamp;
    return all;
}

mrpt::obs::CObservation::Ptr Annotator::table(const FrameResult& frame) const
{
    auto table = mrpt::obs::CObservationRawDAQ::Create();
    table->sensorLabel = kTableLabel;
    table->AIN_channel_count = static_cast<std::uint16_t>(annotationColumns().size());
    table->AIN_interleaved = true;
    for (const TrackReport& track : frame.tracks)
    {
        const std::vector<double> row = annotationRow(frame.time, track);
        table->AIN_double.insert(table->AIN_double.end(), row.begin(), row.end());
    }
    return table;
}

mrpt::obs::CObservation::Ptr Annotator::pose(const TrackReport& track) const
{
    // What the tracker does not estimate, tilt and height, gets a variance that says so.
    constexpr double kHeightVariance = 0.2 * 0.2;
    constexpr double kTiltVariance = 0.1 * 0.1;
    auto pose = mrpt::obs::CObservationRobotPose::Create();
    pose->sensorLabel = std::string(kAnnotationLabel) + "_" + std::to_string(track.id);
    pose->pose.mean =
        mrpt::poses::CPose3D(track.box.x, track.box.y, track.z, track.box.heading, 0, 0);
    pose->pose.cov.setZero();
    // MRPT orders x, y, z, yaw, pitch, roll; the report x, y, heading, speed.
    const int rows[3] = {0, 1, 3};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) pose->pose.cov(rows[i], rows[j]) = track.covariance(i, j);
    pose->pose.cov(2, 2) = kHeightVariance;
    pose->pose.cov(4, 4) = pose->pose.cov(5, 5) = kTiltVariance;
    return pose;
}

mrpt::obs::CObservation::Ptr Annotator::alignment(const PlaneMotion& motion) const
{
    auto pose = mrpt::obs::CObservationRobotPose::Create();
    pose->sensorLabel = kAlignmentLabel;
    pose->pose.mean =
        mrpt::poses::CPose3D(motion.shift.x(), motion.shift.y(), 0, motion.turn, 0, 0);
    pose->pose.cov.setZero();
    return pose;
}

mrpt::obs::CObservation::Ptr Annotator::scene(const FrameResult& frame) const
{
    auto observation = mrpt::obs::CObservation3DScene::Create();
    observation->sensorLabel = "vdamf_scene";
    observation->scene = mrpt::opengl::COpenGLScene::Create();
    for (const TrackReport& track : frame.tracks)
    {
        if (!isPublished(track)) continue;
        observation->scene->insert(boxOf(track));
        observation->scene->insert(headingLine(track));
        observation->scene->insert(nameOf(track));
        const auto trail = trails_.find(track.id);
        if (trail == trails_.end() || trail->second.size() < 2) continue;
        auto line = mrpt::opengl::CSetOfLines::Create();
        for (std::size_t i = 1; i < trail->second.size(); ++i)
        {
            const TrailPoint& a = trail->second[i - 1];
            const TrailPoint& b = trail->second[i];
            line->appendLine(a.x, a.y, a.z, b.x, b.y, b.z);
        }
        line->setColor_u8(colourOf(track));
        observation->scene->insert(line);
    }
    return observation;
}

void Annotator::extendTrails(const FrameResult& frame)
{
    for (const TrackReport& track : frame.tracks)
    {
        if (track.status == TrackStatus::Ended)
        {
            trails_.erase(track.id);
            continue;
        }
        auto& trail = trails_[track.id];
        trail.push_back({frame.time, track.box.x, track.box.y, track.z});
        while (trail.front().time < frame.time - options_.trail) trail.pop_front();
    }
}

}  // namespace vdamf
