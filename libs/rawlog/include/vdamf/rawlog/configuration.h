// SPDX-License-Identifier: BSD-3-Clause
// All options of a tracking run, and their ini form: config.ini.
#pragma once

#include <string>

#include "vdamf/files/ini.h"
#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
struct ScanOptions
{
    std::string label;  ///< sensorLabel; empty: every scan is a frame

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.label, "label", "sensorLabel of the scans to track on; empty: all scans");
    }
};

struct OutputOptions
{
    bool table = true;
    bool poses = true;
    bool scene = true;
    double trail = 3.0;  ///< s
    int gzLevel = 1;
    int gzThreads = 2;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.table, "annotate_table",
              "behind each scan the frame's table as CObservationRawDAQ 'vdamf_tracks'");
        field(self.poses, "annotate_poses",
              "a CObservationRobotPose 'vdamf_track_<id>' for each confirmed track");
        field(self.scene, "annotate_scene",
              "a CObservation3DScene with boxes, identities and trails, for RawLogViewer");
        field(self.trail, "trail_s", 0.0, 60.0, "length of the trails in the scene");
        field(self.gzLevel, "gz_level", 0, 9, "compression of the annotated rawlog; 0: none");
        field(self.gzThreads, "gz_threads", 0, 64,
              "threads that compress it; 0: the tracker's own");
    }
};

/// Everything that config.ini can set, with its defaults.
struct Configuration
{
    ScanOptions scan;
    InsOptions ins;
    TrackerOptions tracker;
    OutputOptions output;
};

/// Strict: throws IniError that lists every problem with file, line and key.
Configuration readConfiguration(const IniDocument& document);

/// The commented ini text that readConfiguration() reads back to the same configuration.
std::string toIni(const Configuration& configuration);

}  // namespace vdamf
