// SPDX-License-Identifier: BSD-3-Clause
// The scans of one scene rewritten into the forms that the simulator does not write: dual returns,
// external files, range cameras, halves by two sensors. The tracks stay what they were.
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/serialization/CArchive.h>

#include <cstring>
#include <functional>

#include "apps/simulated_classes.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationVelodyneScan;
namespace fs = std::filesystem;

class RewrittenScans : public SimulatedClasses
{
protected:
    /// b.rawlog: a.rawlog with its scans of a class by what stands for them.
    template <class Scan>
    void rewrite(const std::function<std::vector<std::string>(const Scan&)>& scansFor) const
    {
        RawlogWriter::Options options;
        options.existing = OutputFile::Existing::Overwrite;
        RawlogWriter writer(at("b.rawlog"), options);
        RawlogReader reader(at("a.rawlog"));
        int rewritten = 0;
        while (const auto entry = reader.next())
        {
            const auto scan = std::dynamic_pointer_cast<Scan>(entry->object);
            if (!scan)
            {
                writer.writeBytes(entry->bytes);
                continue;
            }
            for (const std::string& bytes : scansFor(*scan)) writer.writeBytes(bytes);
            ++rewritten;
        }
        writer.commit();
        EXPECT_GT(rewritten, 10);
    }
};

using Packet = CObservationVelodyneScan::TVelodyneRawPacket;

// Half of a packet's shots, each as two equal returns.
Packet dualHalf(const Packet& packet, int first, std::uint32_t hundredthsPerBlock)
{
    constexpr int kBlocks = CObservationVelodyneScan::BLOCKS_PER_PACKET;
    Packet dual = packet;
    for (int i = 0; i < kBlocks; ++i) dual.blocks[i] = packet.blocks[first + i / 2];
    dual.laser_return_mode = CObservationVelodyneScan::RETMODE_DUAL;
    const auto later = static_cast<std::uint32_t>(first) * hundredthsPerBlock / 100;
    const std::uint32_t stamp = packet.gps_timestamp() + later;
    constexpr std::size_t kStampAt = 1200;
    std::memcpy(reinterpret_cast<char*>(&dual) + kStampAt, &stamp, sizeof stamp);
    return dual;
}

TEST_F(RewrittenScans, AsDualReturnsAreTheSame)
{
    const std::string moving = " --set sensor.instantaneous=false";
    const Tracks single = tracksWith(moving);
    rewrite<CObservationVelodyneScan>(
        [](const CObservationVelodyneScan& scan) -> std::vector<std::string>
        {
            constexpr std::uint32_t kHundredths = 4608;  // of a microsecond, a firing of an HDL-32E
            CObservationVelodyneScan dual = scan;
            dual.scan_packets.clear();
            for (const Packet& packet : scan.scan_packets)
                for (const int first : {0, CObservationVelodyneScan::BLOCKS_PER_PACKET / 2})
                    dual.scan_packets.push_back(dualHalf(packet, first, kHundredths));
            return {serialized(dual)};
        });
    // Packets are stamped in whole microseconds.
    expectSame(single, tracksOf("b.rawlog"), 0.005, 0.05);
}

TEST_F(RewrittenScans, AsStrongestOrLastReturnsAreTheSame)
{
    const Tracks reference = tracksWith("");
    for (const std::uint8_t mode :
         {CObservationVelodyneScan::RETMODE_STRONGEST, CObservationVelodyneScan::RETMODE_LAST})
    {
        rewrite<CObservationVelodyneScan>(
            [mode](CObservationVelodyneScan scan) -> std::vector<std::string>
            {
                for (Packet& packet : scan.scan_packets) packet.laser_return_mode = mode;
                return {serialized(scan)};
            });
        expectSame(reference, tracksOf("b.rawlog"), 0.0, 0.0);
    }
}

TEST_F(RewrittenScans, InExternalFilesAreTheSame)
{
    const Tracks reference = tracksWith(" --set output.scan_class=point_cloud");
    fs::create_directory(at("b_Images"));
    int number = 0;
    rewrite<CObservationPointCloud>(
        [&](CObservationPointCloud scan) -> std::vector<std::string>
        {
            const std::string name = "scan_" + std::to_string(number++) + ".bin";
            mrpt::io::CFileGZOutputStream file((at("b_Images") / name).string());
            mrpt::serialization::archiveFrom(file) << *scan.pointcloud;
            scan.pointcloud.reset();
            scan.setAsExternalStorage(
                name, CObservationPointCloud::ExternalStorageFormat::MRPT_Serialization);
            return {serialized(scan)};
        });
    expectSame(reference, tracksOf("b.rawlog"), 0.0, 0.0);
}

TEST_F(RewrittenScans, AsPointsOfARangeCameraAreTheSame)
{
    const Tracks reference = tracksWith(" --set output.scan_class=point_cloud");
    rewrite<CObservationPointCloud>(
        [](const CObservationPointCloud& scan) -> std::vector<std::string>
        {
            CObservation3DRangeScan camera;
            camera.timestamp = scan.timestamp;
            camera.sensorLabel = scan.sensorLabel;
            camera.sensorPose = scan.sensorPose;
            camera.hasPoints3D = true;
            const auto copy = [](const auto& from, auto& to)
            { to.assign(from.begin(), from.end()); };
            copy(scan.pointcloud->getPointsBufferRef_x(), camera.points3D_x);
            copy(scan.pointcloud->getPointsBufferRef_y(), camera.points3D_y);
            copy(scan.pointcloud->getPointsBufferRef_z(), camera.points3D_z);
            camera.points3D_idxs_x.resize(camera.points3D_x.size());
            camera.points3D_idxs_y.resize(camera.points3D_x.size());
            return {serialized(camera)};
        });
    expectSame(reference, tracksOf("b.rawlog"), 0.0, 0.0);
}

TEST_F(RewrittenScans, InHalvesOfTwoSensorsAreTheSameOnceMerged)
{
    const Tracks reference = tracksWith(" --set output.scan_class=point_cloud");
    rewrite<CObservationPointCloud>(
        [](const CObservationPointCloud& scan) -> std::vector<std::string>
        {
            std::vector<std::string> halves;
            for (const bool left : {false, true})
            {
                CObservationPointCloud half = scan;
                half.sensorLabel = left ? "left" : "right";
                const auto points = mrpt::maps::CSimplePointsMap::Create();
                for (std::size_t i = 0; i < scan.pointcloud->size(); ++i)
                {
                    mrpt::math::TPoint3Df p;
                    scan.pointcloud->getPointFast(i, p.x, p.y, p.z);
                    if ((p.y > 0.0F) == left) points->insertPointFast(p.x, p.y, p.z);
                }
                half.pointcloud = points;
                halves.push_back(serialized(half));
            }
            return halves;
        });
    // The hits come in another order, in which sums round otherwise.
    expectSame(reference, tracksOf("b.rawlog", "--set scan.merge_s=0.02"), 0.002, 0.02);
}

TEST_F(RewrittenScans, OfADepthImageAreThoseOfItsPoints)
{
    // The same points once unprojected from an image by its camera and once by ourselves.
    const auto camera = [](const CObservationPointCloud& scan, bool asImage)
    {
        CObservation3DRangeScan image;
        image.timestamp = scan.timestamp;
        image.sensorLabel = "camera";
        image.sensorPose = scan.sensorPose;
        image.cameraParams.ncols = 640;
        image.cameraParams.nrows = 240;
        image.cameraParams.setIntrinsicParamsFromValues(300.0, 300.0, 320.0, 120.0);
        image.range_is_depth = true;
        image.rangeUnits = 0.005F;
        image.hasRangeImage = asImage;
        image.hasPoints3D = !asImage;
        image.rangeImage.setSize(240, 640);
        image.rangeImage.setZero();
        for (std::size_t i = 0; i < scan.pointcloud->size(); ++i)
        {
            mrpt::math::TPoint3Df p;
            scan.pointcloud->getPointFast(i, p.x, p.y, p.z);
            if (p.x < 1.0F) continue;
            const int column = static_cast<int>(std::lround(320.0F - 300.0F * p.y / p.x));
            const int row = static_cast<int>(std::lround(120.0F - 300.0F * p.z / p.x));
            if (column < 0 || column >= 640 || row < 0 || row >= 240) continue;
            image.rangeImage(row, column) = static_cast<std::uint16_t>(std::lround(p.x / 0.005F));
        }
        for (int row = 0; row < 240; ++row)
            for (int column = 0; column < 640; ++column)
            {
                const float depth = 0.005F * static_cast<float>(image.rangeImage(row, column));
                if (depth == 0.0F) continue;
                image.points3D_x.push_back(depth);
                image.points3D_y.push_back(depth * (320.0F - static_cast<float>(column)) / 300.0F);
                image.points3D_z.push_back(depth * (120.0F - static_cast<float>(row)) / 300.0F);
            }
        image.points3D_idxs_x.resize(image.points3D_x.size());
        image.points3D_idxs_y.resize(image.points3D_x.size());
        return serialized(image);
    };
    simulate(" --set output.scan_class=point_cloud");
    Tracks tracks[2];
    for (const bool asImage : {false, true})
    {
        rewrite<CObservationPointCloud>(
            [&](const CObservationPointCloud& scan)
            { return std::vector<std::string>{camera(scan, asImage)}; });
        tracks[asImage ? 1 : 0] = tracksOf("b.rawlog");
    }
    expectSame(tracks[0], tracks[1], 0.005, 0.1, 6);
}

}  // namespace
}  // namespace vdamf
