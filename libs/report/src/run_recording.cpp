// SPDX-License-Identifier: BSD-3-Clause
#include "run_recording.h"

#include <cmath>

namespace vdamf
{
namespace
{
Json measuredJson(const std::optional<OrientedBox>& box)
{
    if (!box) return nullptr;
    return {rounded(box->x, 3), rounded(box->y, 3), rounded(box->heading, 4),
            rounded(box->length, 3), rounded(box->width, 3)};
}

/// Columns of one track, in the order of the page's data.
void append(Json& columns, std::size_t frame, const TrackReport& t)
{
    const auto add = [&](const char* name, Json value)
    { columns[name].push_back(std::move(value)); };
    add("frame", frame);
    add("status", toString(t.status));
    add("probability", t.vehicleProbability ? rounded(*t.vehicleProbability, 3) : Json(nullptr));
    add("x", rounded(t.box.x, 3));
    add("y", rounded(t.box.y, 3));
    add("z", rounded(t.z, 2));
    add("heading", rounded(t.box.heading, 4));
    add("forward", rounded(t.forwardProbability, 3));
    add("axes", rounded(t.axesProbability, 3));
    add("speed", rounded(t.speed, 3));
    add("yawRate", rounded(t.yawRate, 4));
    add("length", rounded(t.box.length, 3));
    add("width", rounded(t.box.width, 3));
    add("height", rounded(t.height, 2));
    add("hits", t.points);
    add("match", rounded(t.match, 4));
    add("nis", t.nis ? rounded(*t.nis, 3) : Json(nullptr));
    add("faces", toString(t.facesSeen));
    add("varX", rounded(t.covariance(0, 0), 6));
    add("covXY", rounded(t.covariance(0, 1), 6));
    add("varY", rounded(t.covariance(1, 1), 6));
    add("varHeading", rounded(t.covariance(2, 2), 7));
    add("varSpeed", rounded(t.covariance(3, 3), 5));
    add("varLength", rounded(t.lengthVariance, 5));
    add("varWidth", rounded(t.widthVariance, 5));
    add("measured", measuredJson(t.measuredBox));
}
}  // namespace

Json rounded(double value, int decimals)
{
    if (!std::isfinite(value)) return nullptr;
    const double unit = std::pow(10.0, decimals);
    return std::round(value * unit) / unit;
}

Json framesJson(const std::vector<RecordedFrame>& frames)
{
    Json json = {{"time0", frames.front().time}};
    for (const RecordedFrame& frame : frames)
    {
        json["time"].push_back(rounded(frame.time - frames.front().time, 6));
        for (const auto& [name, place] :
             {std::make_pair("origin", frame.origin), std::make_pair("sensor", frame.sensor)})
            json[name].push_back(
                {rounded(place.x(), 3), rounded(place.y(), 3), rounded(place.z(), 3)});
        json["points"].push_back(frame.points);
        json["aboveGround"].push_back(frame.aboveGround);
        json["clusters"].push_back(frame.clusters);
    }
    return json;
}

Json tracksJson(const std::vector<RecordedFrame>& frames)
{
    std::map<std::uint64_t, Json> tracks;
    for (std::size_t f = 0; f < frames.size(); ++f)
        for (const TrackReport& track : frames[f].tracks)
        {
            Json& columns = tracks[track.id];
            if (columns.is_null()) columns = {{"id", track.id}};
            append(columns, f, track);
        }
    Json json = Json::array();
    for (auto& [id, columns] : tracks) json.push_back(std::move(columns));
    return json;
}

}  // namespace vdamf
