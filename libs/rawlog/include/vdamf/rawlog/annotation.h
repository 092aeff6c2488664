// SPDX-License-Identifier: BSD-3-Clause
// What a frame's tracks look like in a rawlog: stock MRPT classes only, so that every stock tool
// reads the file whole.
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CObservationComment.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "vdamf/rawlog/configuration.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// Labels of annotations start with this; such observations are never taken for input.
inline constexpr const char* kAnnotationLabel = "vdamf_track";
/// Of the frame's table.
inline constexpr const char* kTableLabel = "vdamf_tracks";
/// Of where the world of the poses lies in that of the tracks.
inline constexpr const char* kAlignmentLabel = "vdamf_tracks_alignment";
bool isAnnotation(const mrpt::obs::CObservation& observation);
/// Throws std::runtime_error, which begins with `where`, for a sensor's label that would make its
/// scans annotations.
void checkSensorLabel(const std::string& label, const std::string& where);
/// First line of the head's text.
inline constexpr const char* kHeadBegin = "[vdamf]\n";
bool isHead(const mrpt::serialization::CSerializable& entry);
/// Also of others than a run: MRPT stores scenes without their label.
bool isScene(const mrpt::obs::CObservation& observation);

/// First entry of an annotated rawlog, in ini form: program version, world origin, columns of the
/// table, effective configuration. Its time stamp is that of the first frame.
mrpt::obs::CObservationComment headComment(const std::string& version, const std::string& origin,
                                           const std::string& insSource,
                                           const Configuration& configuration,
                                           mrpt::Clock::time_point stamp);

/// Makes the observations that follow a scan. Keeps the trails between frames.
class Annotator
{
public:
    explicit Annotator(const OutputOptions& options) : options_(options) {}

    /// In the order of writing, all with the scan's time stamp: the table (`vdamf_tracks`, one row
    /// a track, columns of annotationColumns()), the poses, the alignment where there is one, the
    /// scene.
    std::vector<mrpt::obs::CObservation::Ptr> annotate(const FrameResult& frame,
                                                       mrpt::Clock::time_point stamp);

private:
    struct TrailPoint
    {
        double time;
        double x, y, z;  // in the world: single precision ends some kilometres from its origin
    };

    mrpt::obs::CObservation::Ptr table(const FrameResult& frame) const;
    mrpt::obs::CObservation::Ptr pose(const TrackReport& track) const;
    mrpt::obs::CObservation::Ptr alignment(const PlaneMotion& motion) const;
    mrpt::obs::CObservation::Ptr scene(const FrameResult& frame) const;
    void extendTrails(const FrameResult& frame);

    OutputOptions options_;
    std::map<std::uint64_t, std::deque<TrailPoint>> trails_;
};

}  // namespace vdamf
