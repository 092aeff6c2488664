// SPDX-License-Identifier: BSD-3-Clause
// Section 5, last step of Fig. 2: is an object a vehicle? Beyond the paper: as a probability that
// grows firm over the frames of a track.
#pragma once

#include <cstddef>
#include <vector>

#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
/// Distance from the separating hyperplane, positive for vehicles, in units of the margin.
/// `features`: of the model's grid.
double vehicleScore(const DiscriminatorModel& model, const std::vector<float>& features);

/// log10(hits / 50), the same from 2000 hits on and below 5: calibrations know no others.
double hitDecades(std::size_t hits);

/// Log-odds of "vehicle" by one frame alone.
double frameLogOdds(const FrameCalibration& calibration, double score, std::size_t hits);

/// What the frames of a track have said so far.
struct VehicleEvidence
{
    double sum = 0.0;     ///< of log-odds
    double frames = 0.0;  ///< fading number
};

/// With one more frame. `prior`: of the frames' calibration.
VehicleEvidence withFrame(const VehicleEvidence& evidence, double logOdds,
                          const TrackCalibration& calibration, double prior);

/// Log-odds that the track is a vehicle; the prior's without frames.
double trackLogOdds(const VehicleEvidence& evidence, const TrackCalibration& calibration);

double toProbability(double logOdds);

}  // namespace vdamf
