// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/sample.h"

#include <algorithm>
#include <utility>

namespace vdamf
{
std::vector<SparseFeature> toSparse(const std::vector<float>& features)
{
    std::vector<SparseFeature> sparse;
    for (std::size_t i = 0; i < features.size(); ++i)
        if (features[i] != 0.0F) sparse.push_back({static_cast<std::uint32_t>(i), features[i]});
    return sparse;
}

std::vector<TrackSamples> groupedByTrack(std::vector<ObjectSample> samples, std::size_t recording,
                                         const std::string& recordingName, const std::string& group)
{
    std::sort(samples.begin(), samples.end(),
              [](const ObjectSample& a, const ObjectSample& b)
              { return std::make_pair(a.track, a.time) < std::make_pair(b.track, b.time); });
    std::vector<TrackSamples> tracks;
    for (ObjectSample& sample : samples)
    {
        if (tracks.empty() || tracks.back().frames.front().track != sample.track)
            tracks.push_back({group, recording, {}, 1});
        tracks.back().frames.push_back(std::move(sample));
    }
    for (TrackSamples& track : tracks)
    {
        if (!track.group.empty()) continue;
        const auto onObject = std::find_if(track.frames.begin(), track.frames.end(),
                                           [](const ObjectSample& s) { return !s.object.empty(); });
        track.group = recordingName + (onObject != track.frames.end()
                                           ? " object " + onObject->object
                                           : " track " + std::to_string(track.frames[0].track));
    }
    return tracks;
}

}  // namespace vdamf
