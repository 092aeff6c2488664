// SPDX-License-Identifier: BSD-3-Clause
// A small simulated street, and what is tracked on it.
#pragma once

#include <mrpt/obs/CObservation.h>

#include <string>
#include <vector>

#include "vdamf/evaluation/tables.h"

namespace vdamf::fuzz
{
/// Poses and scans of a few frames in the order of a recording: a car that drives ahead, seen in a
/// narrow sector. `model` as in a scenario file.
struct Street
{
    std::vector<mrpt::obs::CObservation::Ptr> observations;
    std::vector<TruthRow> truth;
};
Street smallStreet(const std::string& model, int frames, double fieldOfViewDeg);

/// The scan with about so many of its points, as CObservationPointCloud.
mrpt::obs::CObservation::Ptr thinned(const mrpt::obs::CObservation& scan, std::size_t points);

}  // namespace vdamf::fuzz
