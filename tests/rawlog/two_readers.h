// SPDX-License-Identifier: BSD-3-Clause
// How many observations of a rawlog MRPT's own reader gives, and how many ours.
#pragma once

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>

#include "vdamf/rawlog/rawlog_reader.h"

namespace vdamf::test
{
/// Observations that MRPT's own way of reading a rawlog gives.
inline std::size_t countByMrpt(const std::filesystem::path& rawlog)
{
    mrpt::io::CFileGZInputStream file(rawlog.string());
    auto archive = mrpt::serialization::archiveFrom(file);
    std::size_t count = 0;
    mrpt::obs::CActionCollection::Ptr actions;
    mrpt::obs::CSensoryFrame::Ptr frame;
    mrpt::obs::CObservation::Ptr observation;
    std::size_t entry = 0;
    while (mrpt::obs::CRawlog::getActionObservationPairOrObservation(archive, actions, frame,
                                                                     observation, entry))
        count += observation ? 1 : frame ? frame->size() : 0;
    return count;
}

/// Observations that ours gives.
inline std::size_t countByUs(const std::filesystem::path& rawlog)
{
    RawlogReader reader(rawlog);
    std::size_t count = 0;
    while (const auto entry = reader.next())
    {
        const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry->object);
        count += frame ? frame->size() : entry->object ? 1 : 0;
    }
    return count;
}

}  // namespace vdamf::test
