// SPDX-License-Identifier: BSD-3-Clause
// What the discriminator is trained on: objects as the tracker saw them, with what they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vdamf
{
/// A feature that is not zero.
struct SparseFeature
{
    std::uint32_t index = 0;
    float value = 0.0F;
};

enum class ObjectLabel
{
    Unknown,  ///< outside of what is labelled, or half on a vehicle
    Clutter,
    Vehicle
};

/// One track in one frame.
struct ObjectSample
{
    std::uint64_t track = 0;  ///< unique over all recordings
    double time = 0.0;        ///< s
    double range = 0.0;       ///< of the box's centre from the sensor, m
    std::size_t hits = 0;
    ObjectLabel label = ObjectLabel::Unknown;
    std::string object;  ///< of the truth, where it lies on one
    std::vector<SparseFeature> features;
};

std::vector<SparseFeature> toSparse(const std::vector<float>& features);

/// All frames of one track, by time.
struct TrackSamples
{
    /// Tracks of one group are never split between training and test: tracks on the same object,
    /// or of the same scene.
    std::string group;
    std::size_t recording = 0;
    std::vector<ObjectSample> frames;
    int weight = 1;  ///< times that its frames count in training and calibration
};

/// Tracks by rising number, their frames by time, from samples in any order. Their group is
/// `group`, or where that is empty `recordingName` with the object that they lie on first or, where
/// there is none, the track's number.
std::vector<TrackSamples> groupedByTrack(std::vector<ObjectSample> samples, std::size_t recording,
                                         const std::string& recordingName,
                                         const std::string& group);

}  // namespace vdamf
