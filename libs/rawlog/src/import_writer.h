// SPDX-License-Identifier: BSD-3-Clause
// The rawlog of an import: its entries by rising time.
#pragma once

#include <mrpt/obs/CObservation.h>

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
    /// `poses` with times, by rising time.
    ImportWriter(const ImportOutput& output, std::vector<FilePose> poses);

    /// Something between scans, which need not come in its order with them.
    void add(double time, const mrpt::obs::CObservation& observation);
    /// A scan, after all that is earlier.
    void write(double time, const mrpt::obs::CObservation& scan);
    void commit();

private:
    void writeUntil(double time);

    RawlogWriter rawlog_;
    std::vector<FilePose> poses_;
    std::size_t nextPose_ = 0;
    std::vector<std::pair<double, std::string>> waiting_;
};

}  // namespace vdamf
