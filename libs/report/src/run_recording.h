// SPDX-License-Identifier: BSD-3-Clause
// What a report keeps of a run, and its JSON for the page.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "vdamf/tracking/types/track.h"

namespace vdamf
{
using Json = nlohmann::ordered_json;

/// Rounded to some decimals, so that its text is short; null for what is not finite.
Json rounded(double value, int decimals);

struct RecordedFrame
{
    double time = 0.0;  ///< s (UNIX)
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    Eigen::Vector3d sensor = Eigen::Vector3d::Zero();
    std::size_t points = 0;
    std::size_t aboveGround = 0;
    std::size_t clusters = 0;
    std::string hits;  ///< encoded, gz, base64
    std::vector<TrackReport> tracks;
};

/// Times relative to the first frame, places, counts: an array of each.
Json framesJson(const std::vector<RecordedFrame>& frames);

/// One object a track, by id: arrays over the frames it has a row in.
Json tracksJson(const std::vector<RecordedFrame>& frames);

}  // namespace vdamf
