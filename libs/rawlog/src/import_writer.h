// SPDX-License-Identifier: BSD-3-Clause
// The rawlog of an import: its entries by rising time.
#pragma once

#include <mrpt/obs/CObservation.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vdamf/rawlog/import_output.h"
#include "vdamf/rawlog/pose_file.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf
{
RawlogWriter::Options writerOptions(const ImportOutput& output);

/// Scans and what belongs between them.
class ImportWriter
{
public:
    /// `poses` with times, by rising time, of a file.
    ImportWriter(const ImportOutput& output, std::vector<FilePose> poses,
                 std::filesystem::path posesFile);

    /// Something between scans, which need not come in its order with them.
    void add(double time, const mrpt::obs::CObservation& observation);
    /// A scan, after all that is earlier.
    void write(double time, const mrpt::obs::CObservation& scan);
    /// Throws std::runtime_error that names the file of poses where no scan lies within their
    /// times.
    void commit();

private:
    void writeUntil(double time);
    void checkPosesOfScans() const;

    RawlogWriter rawlog_;
    std::vector<FilePose> poses_;
    std::filesystem::path posesFile_;
    std::optional<double> firstScan_;  // s (UNIX)
    double lastScan_ = 0.0;            // s (UNIX)
    std::size_t nextPose_ = 0;
    std::vector<std::pair<double, std::string>> waiting_;
};

}  // namespace vdamf
