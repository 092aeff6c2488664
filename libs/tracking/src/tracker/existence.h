// SPDX-License-Identifier: BSD-3-Clause
// Is a track's object there? Hits speak for it, their lack against it as far as it is in view.
#pragma once

#include "tracker/field_of_view.h"
#include "tracker/track.h"
#include "vdamf/tracking/types/range_profile.h"

namespace vdamf
{
/// What a frame shows of where nothing is. All positions in the frame of its hits, m.
struct OpenView
{
    double time = 0.0;  ///< s
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();
    const RangeProfile& profile;
    FieldOfView field;
};

/// What is known of a track without a measurement.
struct Unseen
{
    bool mayBeVehicle = true;  ///< clutter is not waited for, hidden or not
    bool showsHits = false;    ///< it is there, though hits are too few to tell more
};

/// Share of the box's bearings along which the sensor sees through to behind it: nothing stands
/// there, neither before the box nor in it.
double shareSeenThrough(const OrientedBox& box, const OpenView& view);

/// The least of these shares over the places where the track may be, two standard deviations to
/// either side along the axis that is known least: what may have stopped behind a wall is hidden.
double shareSeenThrough(const Track& track, const OpenView& view);

/// The track after a frame of that time (s) with hits of it, whatever they told.
Track withHit(Track track, double time, const LifecycleOptions& options);

/// The track, confirmed once it was seen often enough for what is known of its axes, its front and
/// its speed.
Track withConfirmation(Track track, const LifecycleOptions& options);

/// The track after a frame without. It coasts, or ends: once it is likely not to be
/// there, was not seen for too long, or may be so far off that nothing tells it from a new one.
Track withMiss(Track track, const OpenView& view, const Unseen& unseen,
               const LifecycleOptions& options);

/// Those that go on.
std::vector<Track> withoutEnded(std::vector<Track> tracks);

}  // namespace vdamf
