// SPDX-License-Identifier: BSD-3-Clause
// The main job: a rawlog in, its vehicles tracked, an annotated rawlog out.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/configuration.h"
#include "vdamf/rawlog/nis_report.h"
#include "vdamf/rawlog/rawlog_reader.h"

namespace vdamf
{
struct TrackRawlogJob
{
    std::filesystem::path input;
    std::optional<std::filesystem::path> output;  ///< annotated rawlog
    std::optional<std::filesystem::path> tracks;  ///< tracks.csv
    std::optional<std::filesystem::path> nis;     ///< table of NisReport
    /// Files that the caller writes beside these: checked not to be the input or another output.
    std::vector<std::filesystem::path> otherOutputs;
    std::filesystem::path configurationFile;  ///< where `configuration` is from, not to be written
                                              ///< over; empty: none
    OutputFile::Existing existing = OutputFile::Existing::Refuse;
    /// Frames to track, [first, last): stamped scans by rising time, counted from 0, without those
    /// that joined the frame of another sensor. Scans outside are not decoded. Entries before the
    /// first one are copied without annotation, those from the next scan behind the last one on are
    /// left out.
    std::uint64_t firstFrame = 0;
    std::uint64_t lastFrame = std::numeric_limits<std::uint64_t>::max();
    Configuration configuration;
    std::string version;  ///< of the program, for the annotation
    /// Of entries that wait for the first frame, whose time the annotation's head is stamped with;
    /// beyond, it gets the stamp of the first scan.
    std::size_t heldBytes = std::size_t{64} << 20;
};

struct TrackRawlogSummary
{
    RawlogSummary read;
    std::uint64_t scans = 0;                 ///< in the range asked for, with a time stamp
    std::uint64_t frames = 0;                ///< tracked and annotated
    std::uint64_t withoutPose = 0;           ///< scans skipped: no INS pose at their time
    std::uint64_t poseTooLate = 0;           ///< of these: it stands too far behind in the file
    std::uint64_t outOfOrder = 0;            ///< scans skipped: earlier than the one before
    std::uint64_t atOneTime = 0;             ///< scans skipped: at the time of the one before
    std::uint64_t unstamped = 0;             ///< scans skipped: without a time stamp
    std::uint64_t unreadable = 0;            ///< scans skipped: cannot be read
    std::uint64_t merged = 0;                ///< scans that joined the frame of another sensor
    std::uint64_t withoutHits = 0;           ///< scans (tracked) that have none
    std::uint64_t ofEarlierRun = 0;          ///< entries that an earlier run added, left out
    std::uint64_t partlyDeskewed = 0;        ///< scans with hits at whose time there is no INS pose
    std::string firstUnreadable;             ///< why
    std::vector<std::string> sensors;        ///< labels of the scans, the first eight
    std::vector<std::string> scanLabels;     ///< also of those not tracked on, the first eight
    std::uint64_t tracksConfirmed = 0;       ///< different identities that were confirmed
    double firstTime = 0.0, lastTime = 0.0;  ///< of the frames, s (UNIX)
    std::string insSource;
    InsReport ins;  ///< what became of its samples
    /// Frames in which tracks went by what stands rather than by the poses, and how far these were
    /// off at most, m and rad.
    std::uint64_t aligned = 0;
    double mostShifted = 0.0, mostTurned = 0.0;
    /// Seconds spent: reading (with parsing), scan to world frame, the tracker's stages, writing.
    double readSeconds = 0.0, frameSeconds = 0.0, writeSeconds = 0.0;
    std::array<double, 8> stageSeconds{};  ///< by Stage
    NisReport nis;
    /// Why the input could not be read on, where the frames end; empty: it was read to its end.
    std::string readError;
    bool interrupted = false;
};

/// The range asked for begins behind the last frame.
class NoFrameInRange : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Called after each frame with its result (for reports) and the share of the input read. The frame
/// is in the world of the tracks.
using FrameListener =
    std::function<void(const LadarFrame& frame, const FrameResult& result, double progress)>;

/// Called after each frame of a first reading, with the share of all work that is done.
using FirstReadingListener = std::function<void(double progress)>;

/// Throws std::runtime_error where an output is the input, or one file is named for two outputs.
/// trackRawlog() checks it too, before it opens any output.
void checkPaths(const TrackRawlogJob& job);

/// Runs the job. Memory does not grow with the input, but for a row of the NIS table a track, where
/// that is asked for: a scan waits for INS poses at most over one second of entries behind its end,
/// and for earlier scans that stand behind it in the file over 0.2 seconds. Outputs appear under
/// their names when whole; after an error (thrown as std::runtime_error, its message names the file
/// and the cause) or an interruption the frames done so far are in `<output>.partial`. `stop`, set
/// from a signal handler, ends the run after the current frame.
/// With [output] hindsight the input is read twice: first to track, of which nothing is written and
/// the listener hears nothing, then to annotate. In between the reports of all frames are in
/// memory, half a kilobyte each. It must be a file then; the frames of a first reading that was
/// ended count for nothing.
TrackRawlogSummary trackRawlog(const TrackRawlogJob& job, const std::atomic<bool>& stop,
                               const FrameListener& listener = {},
                               const FirstReadingListener& firstReading = {});

}  // namespace vdamf
