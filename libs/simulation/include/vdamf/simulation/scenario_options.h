// SPDX-License-Identifier: BSD-3-Clause
// The sections of a scenario file, key by key.
#pragma once

#include <string>

#include "vdamf/simulation/spinning_ladar.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
/// Section [scenario].
struct RunOptions
{
    double duration = 10.0;  ///< s
    double rate = 10.0;      ///< 1/s
    double startTime = 0.0;  ///< s (UNIX)
    double insRate = 50.0;   ///< 1/s
    int seed = 1;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.duration, "duration_s", 0.1, 3600.0, "length of the recording");
        field(self.rate, "rate_hz", 1.0, 20.0, "revolutions of the LADAR");
        field(self.startTime, "start_time_s", 0.0, 4e9, "UNIX time of the first revolution");
        field(self.insRate, "ins_rate_hz", 1.0, 1000.0, "pose observations of the platform");
        field(self.seed, "seed", 0, 2147483647, "of all that is random");
    }
};

/// Section [sensor].
struct SensorOptions
{
    LadarModel model = LadarModel::HDL32E;
    double x = 0.0;                          ///< vehicle frame, m
    double y = 0.0;                          ///< m
    double z = 2.0;                          ///< above the ground, m
    double heading = 0.0;                    ///< of azimuth 0 in the vehicle frame, rad
    double fieldOfView = 6.283185307179586;  ///< centred on azimuth 0, rad
    double rangeNoise = -1.0;                ///< m
    double maxRange = -1.0;                  ///< m
    double halfLossStrength = 0.001;
    double glassLoss = 0.8;
    bool instantaneous = true;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.model, "model", "the sensor");
        field(self.x, "x_m", -20.0, 20.0, "position on the platform, to the front");
        field(self.y, "y_m", -20.0, 20.0, "position on the platform, to the left");
        field(self.z, "z_m", 0.1, 20.0, "height above the ground");
        field(self.heading, "heading_deg", -180.0, 180.0, "of the sensor on the platform");
        field(self.fieldOfView, "field_of_view_deg", 1.0, 360.0,
              "azimuths around the sensor's heading that are recorded");
        field(self.rangeNoise, "range_noise_m", -1.0, 1.0,
              "standard deviation; negative: as the data sheet says");
        field(self.maxRange, "max_range_m", -1.0, 200.0, "negative: as the data sheet says");
        field(self.halfLossStrength, "half_loss_strength", 0.0, 10.0,
              "reflectivity cos(incidence) (10 m / range)^2 at which half of the returns are lost");
        field(self.glassLoss, "glass_loss", 0.0, 1.0, "share of rays onto glass without return");
        field(self.instantaneous, "instantaneous", "the world stands still during a revolution");
    }
};

/// Section [platform].
struct PlatformOptions
{
    double x = 0.0;        ///< rear axle at the start, scene frame, m
    double y = 0.0;        ///< m
    double heading = 0.0;  ///< rad
    double speed = 0.0;    ///< m/s
    std::string segments;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.x, "x_m", -1e5, 1e5, "middle of the rear axle at the start, to the east");
        field(self.y, "y_m", -1e5, 1e5, "middle of the rear axle at the start, to the north");
        field(self.heading, "heading_deg", -360.0, 360.0, "counter-clockwise from east");
        field(self.speed, "speed_mps", -60.0, 60.0, "at the start");
        field(self.segments, "segments",
              "duration_s acceleration_mps2 curvature_1pm, ... ; straight on where empty");
    }
};

}  // namespace vdamf
