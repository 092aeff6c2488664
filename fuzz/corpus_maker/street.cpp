// SPDX-License-Identifier: BSD-3-Clause
#include "street.h"

#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include "pose_sources.h"
#include "scan_classes.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf::fuzz
{
namespace
{
Scenario scenarioOf(const std::string& model, double fieldOfViewDeg)
{
    const std::string text =
        "[scenario]\nduration_s = 10\nstart_time_s = 1500000000\n"
        "ins_rate_hz = 10\n[sensor]\nz_m = 1.8\nmodel = " +
        model + "\nfield_of_view_deg = " + std::to_string(fieldOfViewDeg) +
        "\n[platform]\nspeed_mps = 8\n[object ahead]\nclass = car\n"
        "x_m = 12\ny_m = 0.5\nspeed_mps = 9\n";
    return readScenario(IniDocument::parse(text, "small street"));
}
}  // namespace

Street smallStreet(const std::string& model, int frames, double fieldOfViewDeg)
{
    const Scenario scenario = scenarioOf(model, fieldOfViewDeg);
    InsSimulator ins(scenario);
    PoseRecorder poses(scenario);
    Street street;
    const auto addPose = [&]
    {
        for (const auto& pose : poses.observations(ins.next())) street.observations.push_back(pose);
    };
    addPose();
    for (int i = 0; i < frames; ++i)
    {
        const SimulatedFrame frame = simulateFrame(scenario, i);
        for (const SimulatedScan& scan : frame.scans)
            street.observations.push_back(scanObservation(scenario, scan));
        street.truth.insert(street.truth.end(), frame.truth.begin(), frame.truth.end());
        addPose();
    }
    return street;
}

mrpt::obs::CObservation::Ptr thinned(const mrpt::obs::CObservation& observation, std::size_t points)
{
    const PointCloud cloud = scanFrom(observation)->points;
    const std::size_t step = std::max<std::size_t>(1, cloud.size() / points);
    auto map = mrpt::maps::CPointsMapXYZI::Create();
    for (std::size_t i = 0; i < cloud.size(); i += step)
    {
        map->insertPointFast(cloud.x[i], cloud.y[i], cloud.z[i]);
        map->setPointIntensity(map->size() - 1, cloud.intensity[i]);
    }
    auto thin = mrpt::obs::CObservationPointCloud::Create();
    thin->timestamp = observation.timestamp;
    thin->sensorLabel = observation.sensorLabel;
    thin->pointcloud = map;
    return thin;
}

}  // namespace vdamf::fuzz
