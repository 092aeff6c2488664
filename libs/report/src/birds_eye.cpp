// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/birds_eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace vdamf
{
namespace
{
std::string format(const char* pattern, double a, double b)
{
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), pattern, a, b);
    return text.data();
}

std::string colourOf(std::uint64_t id)
{
    const double hue = std::fmod(static_cast<double>(id) * 222.492235949962, 360.0);
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "hsl(%.0f,85%%,62%%)", hue);
    return text.data();
}
}  // namespace

void BirdsEye::add(const LadarFrame& frame, const FrameResult& result)
{
    frame_ = frame;
    result_ = result;
    const double oldest = result.time - options_.trailSeconds;
    const auto extend = [oldest](std::deque<TrailPoint>& trail, const TrailPoint& point)
    {
        trail.push_back(point);
        while (trail.front().time < oldest) trail.pop_front();
    };
    for (const TrackReport& track : result.tracks)
    {
        if (track.status == TrackStatus::Ended)
            trails_.erase(track.id);
        else
            extend(trails_[track.id], {result.time, track.box.centre()});
    }
    extend(sensorTrail_, {result.time, frame.sensor.head<2>()});
}

Eigen::Vector2d BirdsEye::pixel(const Eigen::Vector2d& world) const
{
    const double scale = options_.pixelsAcross / options_.metresAcross;
    const Eigen::Vector2d offset = world - frame_.sensor.head<2>();
    return {scale * (offset.x() + 0.5 * options_.metresAcross),
            scale * (0.5 * options_.metresUp - offset.y())};
}

bool BirdsEye::visible(const Eigen::Vector2d& world, double margin) const
{
    const Eigen::Vector2d offset = (world - frame_.sensor.head<2>()).cwiseAbs();
    return offset.x() < 0.5 * options_.metresAcross + margin &&
           offset.y() < 0.5 * options_.metresUp + margin;
}

std::string BirdsEye::pointsSvg() const
{
    // One path a height band, one dot a pixel: dots are zero-length strokes with round ends.
    constexpr std::array<double, 2> kBands{-1.5, -0.4};  // m, relative to the sensor
    constexpr std::array<const char*, 3> kColours{"#31404f", "#6d8296", "#b9c9d6"};
    std::array<std::set<std::pair<long, long>>, 3> dots;
    for (std::size_t i = 0; i < frame_.points.size(); ++i)
    {
        const Eigen::Vector2d world(frame_.origin.x() + frame_.points.x[i],
                                    frame_.origin.y() + frame_.points.y[i]);
        if (!visible(world, 0.0)) continue;
        const double z = frame_.origin.z() + frame_.points.z[i] - frame_.sensor.z();
        const std::size_t band = z < kBands[0] ? 0 : z < kBands[1] ? 1 : 2;
        const Eigen::Vector2d p = pixel(world);
        // Bands lie over each other: what stands up hides the ground.
        dots[band].emplace(std::lround(p.x()), std::lround(p.y()));
    }
    std::string svg;
    for (std::size_t band = 0; band < dots.size(); ++band)
    {
        svg += std::string("<path stroke=\"") + kColours[band] +
               "\" stroke-width=\"1.6\" stroke-linecap=\"round\" d=\"";
        for (const auto& [x, y] : dots[band])
            svg.append("M")
                .append(std::to_string(x))
                .append(" ")
                .append(std::to_string(y))
                .append("h0");
        svg += "\"/>\n";
    }
    return svg;
}

std::string BirdsEye::outlineSvg(const OrientedBox& box) const
{
    std::string points;
    for (const Eigen::Vector2d& corner : corners(box))
        points += format("%.1f,%.1f ", pixel(corner).x(), pixel(corner).y());
    return points;
}

std::string BirdsEye::tracksSvg() const
{
    std::string svg;
    for (const TrackReport& track : result_.tracks)
    {
        if (track.status != TrackStatus::Confirmed && track.status != TrackStatus::Coasting)
            continue;
        if (!visible(track.box.centre(), 5.0)) continue;
        if (track.isVehicle == false)
        {
            svg += "<polygon fill=\"none\" stroke=\"#55636f\" points=\"" + outlineSvg(track.box) +
                   "\"/>\n";
            continue;
        }
        const std::string colour = colourOf(track.id);
        const auto trail = trails_.find(track.id);
        if (trail != trails_.end() && trail->second.size() > 1)
        {
            svg += "<polyline fill=\"none\" stroke=\"" + colour +
                   "\" stroke-width=\"2\" stroke-opacity=\"0.6\" points=\"";
            for (const TrailPoint& p : trail->second)
                svg += format("%.1f,%.1f ", pixel(p.position).x(), pixel(p.position).y());
            svg += "\"/>\n";
        }
        svg += "<polygon fill=\"" + colour + "\" fill-opacity=\"0.15\" stroke=\"" + colour +
               "\" stroke-width=\"2\"" +
               (track.status == TrackStatus::Coasting ? " stroke-dasharray=\"5 4\"" : "") +
               " points=\"" + outlineSvg(track.box) + "\"/>\n";
        // A line over the front, and how far it gets in a second.
        const Eigen::Vector2d ahead = rotation(track.box.heading) * Eigen::Vector2d::UnitX();
        const Eigen::Vector2d front = track.box.centre() + 0.5 * track.box.length * ahead;
        const Eigen::Vector2d from = pixel(track.box.centre());
        const Eigen::Vector2d to = pixel(front + std::max(0.0, track.speed) * ahead);
        svg += "<path stroke=\"" + colour + "\" stroke-width=\"2\" d=\"M" +
               format("%.1f %.1f", from.x(), from.y()) + "L" + format("%.1f %.1f", to.x(), to.y()) +
               "\"/>\n";
        const Eigen::Vector2d label = pixel(track.box.centre()) + Eigen::Vector2d(8.0, -14.0);
        svg += "<text fill=\"" + colour + "\" x=\"" +
               format("%.0f\" y=\"%.0f\"", label.x(), label.y()) + ">" + std::to_string(track.id);
        if (std::abs(track.speed) > 1.0) svg += format(" %.1f m/s", track.speed, 0.0);
        svg += "</text>\n";
    }
    return svg;
}

std::string BirdsEye::svg() const
{
    const int width = options_.pixelsAcross;
    const int height =
        static_cast<int>(std::lround(width * options_.metresUp / options_.metresAcross));
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                      std::to_string(width) + " " + std::to_string(height) +
                      "\" font-family=\"sans-serif\" font-size=\"14\">\n<rect width=\"100%\" "
                      "height=\"100%\" fill=\"#10151b\"/>\n";
    // In a window of another shape there is more to see than the view.
    svg += "<clipPath id=\"view\"><rect width=\"" + std::to_string(width) + "\" height=\"" +
           std::to_string(height) + "\"/></clipPath>\n<g clip-path=\"url(#view)\">\n";
    svg += pointsSvg();
    svg +=
        "<polyline fill=\"none\" stroke=\"#ffffff\" stroke-width=\"2\" stroke-opacity=\"0.7\" "
        "points=\"";
    for (const TrailPoint& p : sensorTrail_)
        svg += format("%.1f,%.1f ", pixel(p.position).x(), pixel(p.position).y());
    svg += "\"/>\n";
    const Eigen::Vector2d sensor = pixel(frame_.sensor.head<2>());
    svg += "<circle r=\"6\" fill=\"#ffffff\" " +
           format("cx=\"%.1f\" cy=\"%.1f\"/>\n", sensor.x(), sensor.y());
    svg += tracksSvg();
    // Scale bar: 10 m.
    const double bar = 10.0 * width / options_.metresAcross;
    svg += "<path stroke=\"#ffffff\" stroke-width=\"2\" d=\"M20 " + std::to_string(height - 20) +
           format("h%.1f\"/>", bar, 0.0) + "\n<text fill=\"#ffffff\" x=\"24\" y=\"" +
           std::to_string(height - 26) + "\">10 m</text>\n</g>\n</svg>\n";
    return svg;
}

}  // namespace vdamf
