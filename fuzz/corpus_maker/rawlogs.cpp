// SPDX-License-Identifier: BSD-3-Clause
// Rawlogs with one object of each class that matters, short drives, and Velodyne packets.
#include <mrpt/core/Clock.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <functional>

#include "corpus.h"
#include "street.h"
#include "vdamf/files/gz_member.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf::fuzz
{
namespace
{
using namespace mrpt::obs;

template <class Observation>
Observation stamped(const std::string& label)
{
    Observation observation;
    observation.timestamp = mrpt::Clock::fromDouble(1.5e9);
    observation.sensorLabel = label;
    return observation;
}

std::string gps()
{
    auto observation = stamped<CObservationGPS>("gps");
    gnss::Message_NMEA_GGA gga;
    gga.fields.fix_quality = 4;
    gga.fields.latitude_degrees = 37.0;
    observation.setMsg(gga);
    observation.setMsg(gnss::Message_NMEA_RMC());
    gnss::Message_NV_OEM6_INSPVAS pvas;
    pvas.fields.lat = 37.0;
    observation.setMsg(pvas);
    return serialized(observation);
}

std::string rangeCamera()
{
    auto scan = stamped<CObservation3DRangeScan>("flash");
    scan.cameraParams.ncols = 8;
    scan.cameraParams.nrows = 6;
    scan.cameraParams.setIntrinsicParamsFromValues(8.0, 8.0, 4.0, 3.0);
    scan.hasRangeImage = true;
    scan.rangeImage_setSize(6, 8);
    scan.rangeImage.fill(9000);
    std::string bytes = serialized(scan);
    scan.hasPoints3D = true;
    scan.resizePoints3DVectors(5);
    return bytes + serialized(scan);
}

std::string rotatingScan()
{
    auto scan = stamped<CObservationRotatingScan>("spin");
    scan.lidarModel = "VLP-16";
    scan.rowCount = 16;
    scan.columnCount = 6;
    scan.rangeResolution = 0.002;
    scan.sweepDuration = 0.1;
    scan.rangeImage.resize(16, 6);
    scan.rangeImage.fill(5000);
    scan.intensityImage.resize(16, 6);
    scan.intensityImage.fill(90);
    return serialized(scan);
}

std::string sensoryFrame()
{
    CSensoryFrame frame;
    auto odometry = stamped<CObservationOdometry>("wheels");
    frame.insert(CObservationOdometry::Create(odometry));
    auto scan = stamped<CObservation2DRangeScan>("line");
    scan.resizeScanAndAssign(40, 4.0F, true);
    frame.insert(CObservation2DRangeScan::Create(scan));
    CActionRobotMovement2D::TMotionModelOptions model;
    model.modelSelection = CActionRobotMovement2D::mmThrun;
    model.thrunModel.nParticlesCount = 4;
    CActionRobotMovement2D movement;
    movement.timestamp = mrpt::Clock::fromDouble(1.5e9);
    movement.computeFromOdometry(mrpt::poses::CPose2D(0.3, 0.0, 0.02), model);
    CActionCollection actions;
    actions.insert(movement);
    return serialized(actions) + serialized(frame);
}

std::string others()
{
    auto cloud = stamped<CObservationPointCloud>("cloud");
    auto map = mrpt::maps::CSimplePointsMap::Create();
    for (int i = 0; i < 20; ++i) map->insertPointFast(static_cast<float>(i), 2.0F, 1.0F);
    cloud.pointcloud = map;
    auto comment = stamped<CObservationComment>("");
    comment.text = "[about]\nname = test\n";
    return serialized(comment) + serialized(stamped<CObservationIMU>("imu")) + serialized(cloud) +
           "\x87nullptr\x88" + std::string("\x86") + "a::Own" + std::string("\0data\x88", 6) +
           serialized(stamped<CObservationRobotPose>("ins"));
}

/// Velodyne packets as the target takes them: a byte for the sensor in front.
std::string packets(char model, const CObservationVelodyneScan& scan)
{
    std::string bytes(1, model);
    for (const auto& packet : scan.scan_packets)
        bytes.append(reinterpret_cast<const char*>(&packet), sizeof packet);
    return bytes;
}

bool hasReturn(const CObservationVelodyneScan::TVelodyneRawPacket& packet)
{
    for (const auto& block : packet.blocks)
        for (const auto& one : block.laser_returns)
            if (one.distance() != 0) return true;
    return false;
}

void dropEmptyPackets(CObservationVelodyneScan& scan)
{
    auto& all = scan.scan_packets;
    all.erase(std::remove_if(all.begin(), all.end(), std::not_fn(hasReturn)), all.end());
}

void addSensors(Corpus& corpus)
{
    constexpr std::size_t kPackets = 2;
    char number = 0;
    for (const char* model : {"VLP-16", "HDL-32E", "HDL-64E"})
    {
        const Street street = smallStreet(model, 1, 4.0);
        auto scan = dynamic_cast<const CObservationVelodyneScan&>(*street.observations.at(1));
        dropEmptyPackets(scan);
        scan.scan_packets.resize(std::min(kPackets, scan.scan_packets.size()));
        const std::string name(model);
        corpus["rawlog/" + name] = serialized(*street.observations.at(0)) + serialized(scan);
        corpus["velodyne/" + name] = packets(number++, scan);
    }
}

std::string drive(const std::string& model, int frames, double fieldOfViewDeg, std::size_t points)
{
    std::string bytes;
    for (const auto& observation : smallStreet(model, frames, fieldOfViewDeg).observations)
    {
        auto* scan = dynamic_cast<CObservationVelodyneScan*>(observation.get());
        if (scan != nullptr) dropEmptyPackets(*scan);
        const bool thin = points > 0 && scan != nullptr;
        bytes += serialized(thin ? *thinned(*observation, points) : *observation);
    }
    return bytes;
}
}  // namespace

Corpus rawlogCorpus()
{
    Corpus corpus = {{"rawlog/gps", gps()},
                     {"rawlog/range_camera", rangeCamera()},
                     {"rawlog/rotating_scan", rotatingScan()},
                     {"rawlog/sensory_frame", sensoryFrame()},
                     {"rawlog/others", others()}};
    corpus["rawlog/gz"] = gzMember(sensoryFrame(), 6) + gzMember(others(), 1);
    addSensors(corpus);
    corpus["track/clouds"] = drive("VLP-16", 5, 16.0, 200);
    corpus["track/packets"] = drive("VLP-16", 4, 6.0, 0);
    corpus["track/line_scanner"] = drive("LMS-291", 5, 0.0, 0);
    corpus["track/sensory_frame"] = corpus["rawlog/others"] + corpus["rawlog/sensory_frame"];
    return corpus;
}

}  // namespace vdamf::fuzz
