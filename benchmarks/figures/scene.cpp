// SPDX-License-Identifier: BSD-3-Clause
#include "figures/scene.h"

#include <set>

#include "figures/formatted.h"
#include "figures/scale_bar.h"
#include "vdamf/tracking/preprocessing/ground.h"

namespace vdamf
{
namespace
{
constexpr double kSceneScale = 14.0;  // pixels a metre
constexpr double kAhead = 62.0;       // m shown in front of the sensor
constexpr double kBehind = 8.0;       // m
constexpr double kAside = 22.0;       // m

Eigen::Vector2d scenePixel(const Eigen::Vector2d& fromSensor)
{
    return {kSceneScale * (fromSensor.x() + kBehind), kSceneScale * (kAside - fromSensor.y())};
}

bool isShown(const Eigen::Vector2d& at)
{
    return at.x() > -kBehind && at.x() < kAhead && std::abs(at.y()) < kAside;
}

std::string boxSvg(const OrientedBox& box, const Eigen::Vector2d& sensor, const std::string& colour)
{
    std::string svg = "<polygon points=\"";
    for (const Eigen::Vector2d& corner : corners(box))
        svg += formatted("%.1f,%.1f ", scenePixel(corner - sensor).x(),
                         scenePixel(corner - sensor).y());
    svg += "\" fill=\"" + colour + "\" fill-opacity=\"0.12\" stroke=\"" + colour +
           "\" stroke-width=\"2\"/>\n";
    const Eigen::Vector2d at = scenePixel(box.centre() - sensor);
    const Eigen::Vector2d here = scenePixel(Eigen::Vector2d::Zero());
    return svg + formatted("<path d=\"M%.1f %.1fL%.1f %.1f\"", here.x(), here.y(), at.x(), at.y()) +
           " stroke=\"" + colour + "\" stroke-opacity=\"0.5\" stroke-dasharray=\"4 5\"/>\n";
}
}  // namespace

std::string sceneSvg(const LadarFrame& frame, const FrameResult& result)
{
    const Eigen::Vector2d sensor = frame.sensor.head<2>();
    const double height = 2.0 * kSceneScale * kAside;
    std::string svg = formatted(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" "
        "height=\"%.0f\" font-family=\"sans-serif\" font-size=\"12\">\n",
        kSceneScale * (kAhead + kBehind), height + 28.0);
    svg +=
        "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n<path stroke=\"#555\" "
        "stroke-width=\"1.5\" stroke-linecap=\"round\" d=\"";
    std::set<std::pair<long, long>> dots;
    for (const std::uint32_t i : removeGround(frame, {}).index)
    {
        const Eigen::Vector2d at =
            frame.origin.head<2>() +
            Eigen::Vector2f(frame.points.x[i], frame.points.y[i]).cast<double>() - sensor;
        if (!isShown(at)) continue;
        dots.emplace(std::lround(scenePixel(at).x()), std::lround(scenePixel(at).y()));
    }
    for (const auto& [x, y] : dots)
        svg.append("M")
            .append(std::to_string(x))
            .append(" ")
            .append(std::to_string(y))
            .append("h0");
    svg += "\"/>\n";
    for (const TrackReport& track : result.tracks)
    {
        if (track.status != TrackStatus::Confirmed || !isShown(track.box.centre() - sensor))
            continue;
        svg += boxSvg(track.box, sensor, track.isVehicle.value_or(false) ? "#d11" : "#2a2");
        const Eigen::Vector2d at = scenePixel(track.box.centre() - sensor);
        svg += formatted("<text x=\"%.0f\" y=\"%.0f\">%.2f</text>\n", at.x() + 6.0, at.y() - 12.0,
                         track.vehicleProbability.value_or(0.0));
    }
    svg += boxSvg({sensor.x() - 0.8, sensor.y(), 0.0, 4.4, 1.8}, sensor, "#24c");
    svg += formatted("<text x=\"6\" y=\"%.0f\">", height + 18.0) +
           "red: vehicle; green: no vehicle; number: probability of a vehicle; blue: sensor "
           "platform; dashed: lines of sight; grey: hits above the ground</text>\n";
    return svg +
           scaleBar(kSceneScale * (kAhead + kBehind) - 20.0, height + 20.0, kSceneScale, 5.0) +
           "</svg>\n";
}

}  // namespace vdamf
