// SPDX-License-Identifier: BSD-3-Clause
// All options of a tracking run, and their ini form: config.ini.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vdamf/files/ini.h"
#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
struct ScanOptions
{
    static constexpr double kLongestMerge = 0.2;  ///< s
    std::string label;                            ///< sensorLabel; empty: any
    bool deskew = true;
    double merge = 0.0;  ///< s

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.label, "label",
              "sensorLabel of the scans to track on; empty: all scans, but those of line "
              "scanners and range cameras only as long as there are no others");
        field(self.deskew, "deskew",
              "hits are placed by the pose of the vehicle at their own times, where the scan has "
              "such times, and not by that at the scan's time");
        field(self.merge, "merge_s", 0.0, kLongestMerge,
              "scans of other sensors that begin at most this much later become one frame with a "
              "scan; 0: each scan is a frame");
    }
};

struct OutputOptions
{
    bool table = true;
    bool poses = true;
    bool scene = true;
    bool hindsight = false;
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
        field(
            self.hindsight, "hindsight",
            "each frame tells what the whole run tells of it: one size and front of each vehicle, "
            "tracks from when they were first seen; the rawlog is read twice");
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

/// Strict: throws IniError that lists every problem with file, line and key. With the contents of
/// the files that it names, and their paths absolute: a relative path in the document counts from
/// its folder or, where there is no such file, from the current one, one of IniDocument::set() from
/// the current one alone.
Configuration readConfiguration(const IniDocument& document);

/// The same without them, and with all paths as they are written.
Configuration readSettings(const IniDocument& document);

/// The files that it names, each with its key; without a path where it names none.
std::vector<NamedInput> filesNamedBy(const Configuration& configuration);

/// Of a file, or the built-in one where no file is named, with "section.key=value" over it.
Configuration loadConfiguration(const std::filesystem::path& file,
                                const std::vector<std::string>& assignments = {});

/// The commented ini text that readConfiguration() reads back to the same configuration.
std::string toIni(const Configuration& configuration);

}  // namespace vdamf
