// SPDX-License-Identifier: BSD-3-Clause
// The sections of a scenario file, key by key.
#pragma once

#include <string>

#include "vdamf/simulation/ray_caster.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
constexpr double kLongestScene = 3600.0;  ///< s

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
        field(self.duration, "duration_s", 0.1, kLongestScene, "length of the recording");
        field(self.rate, "rate_hz", 1.0, 20.0, "scans of the LADAR");
        field(self.startTime, "start_time_s", 0.0, 4e9, "UNIX time of the first scan");
        field(self.insRate, "ins_rate_hz", 1.0, 1000.0, "pose observations of the platform");
        field(self.seed, "seed", 0, 2147483647, "of all that is random");
    }
};

/// Section [ins]: what is wrong with the poses. The truth stays exact.
struct InsErrorOptions
{
    double positionNoise = 0.0;  ///< each axis, white, m
    double headingNoise = 0.0;   ///< white, rad
    double tiltNoise = 0.0;      ///< pitch and roll, white, rad
    double positionBias = 0.0;   ///< each axis, m
    double headingBias = 0.0;    ///< rad
    double biasTime = 60.0;      ///< s
    double lossShare = 0.0;
    double gapEvery = 10.0;  ///< s
    double gapLength = 0.0;  ///< s

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.positionNoise, "position_noise_m", 0.0, 100.0,
              "standard deviation from pose to pose, each axis");
        field(self.headingNoise, "heading_noise_deg", 0.0, 30.0,
              "standard deviation from pose to pose");
        field(self.tiltNoise, "tilt_noise_deg", 0.0, 30.0,
              "of pitch and roll, standard deviation from pose to pose");
        field(self.positionBias, "position_bias_m", 0.0, 100.0,
              "standard deviation of a slowly drifting error, each axis");
        field(self.headingBias, "heading_bias_deg", 0.0, 30.0,
              "standard deviation of a slowly drifting error");
        field(self.biasTime, "bias_time_s", 0.1, 1e5, "correlation time of the drifting errors");
        field(self.lossShare, "loss_share", 0.0, 0.99, "share of single poses that are missing");
        field(self.gapEvery, "gap_every_s", 0.1, 1e5, "time from one gap's end to the next one's");
        field(self.gapLength, "gap_length_s", 0.0, 1e5, "time without poses; 0: no gaps");
    }
};

/// Section [sensor] or [sensor NAME].
struct SensorOptions
{
    LadarModel model = LadarModel::HDL32E;
    double x = 0.0;            ///< vehicle frame, m
    double y = 0.0;            ///< m
    double z = 2.0;            ///< above the ground, m
    double heading = 0.0;      ///< of azimuth 0 in the vehicle frame, rad
    double pitch = 0.0;        ///< rad
    double roll = 0.0;         ///< rad
    double rate = 0.0;         ///< 1/s
    double delay = 0.0;        ///< s
    double fieldOfView = 0.0;  ///< centred on azimuth 0, rad
    double resolution = 0.0;   ///< rad
    double rangeNoise = -1.0;  ///< m
    double maxRange = -1.0;    ///< m
    double halfLossStrength = -1.0;
    double glassLoss = LadarMount{}.glassLoss;
    bool instantaneous = true;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.model, "model", "the sensor");
        field(self.x, "x_m", -20.0, 20.0, "position on the platform, to the front");
        field(self.y, "y_m", -20.0, 20.0, "position on the platform, to the left");
        field(self.z, "z_m", 0.1, 20.0, "height above the ground");
        field(self.heading, "heading_deg", -180.0, 180.0, "of the sensor on the platform");
        field(self.pitch, "pitch_deg", -90.0, 90.0, "positive: looks down");
        field(self.roll, "roll_deg", -180.0, 180.0, "positive: the right side is lower");
        field(self.rate, "rate_hz", 0.0, 100.0, "scans; 0: as [scenario] says");
        field(self.delay, "delay_s", 0.0, 10.0, "of its first scan behind the begin");
        field(self.fieldOfView, "field_of_view_deg", 0.0, 360.0,
              "azimuths around the sensor's heading that are recorded; 0: as the data sheet says");
        field(self.resolution, "resolution_deg", 0.0, 5.0,
              "of a line scanner; 0: as the data sheet says");
        field(self.rangeNoise, "range_noise_m", -1.0, 1.0,
              "standard deviation; negative: as the data sheet says");
        field(self.maxRange, "max_range_m", -1.0, 200.0, "negative: as the data sheet says");
        field(self.halfLossStrength, "half_loss_strength", -1.0, 10.0,
              "received share of light at which half of the returns are lost; 0: none are; "
              "negative: as the sensor has it");
        field(self.glassLoss, "glass_loss", 0.0, 1.0, "share of rays onto glass without return");
        field(self.instantaneous, "instantaneous", "the world stands still during a scan");
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
