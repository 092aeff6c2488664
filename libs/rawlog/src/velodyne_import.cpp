// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/velodyne_import.h"

#include <mrpt/core/Clock.h>

#include <map>
#include <stdexcept>

#include "import_writer.h"
#include "kitti_observations.h"
#include "nmea.h"
#include "sweep_assembler.h"

namespace vdamf
{
namespace
{
std::string addressText(std::uint32_t address)
{
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8)
        text += std::to_string(address >> static_cast<unsigned>(shift) & 0xffU) +
                (shift > 0 ? "." : "");
    return text;
}

mrpt::obs::VelodyneCalibration calibrationOf(const VelodyneImport& job)
{
    mrpt::obs::VelodyneCalibration calibration;
    if (job.calibration.empty()) return calibration;
    if (!std::filesystem::is_regular_file(job.calibration))
        throw std::runtime_error(job.calibration.string() + ": is missing, or no file");
    if (!calibration.loadFromXMLFile(job.calibration.string()) ||
        calibration.laser_corrections.empty())
        throw std::runtime_error(job.calibration.string() +
                                 ": no calibration of a Velodyne sensor (XML, as VeloView has it)");
    return calibration;
}

std::vector<FilePose> timedPoses(const VelodyneImport& job)
{
    if (job.poses.empty()) return {};
    std::vector<FilePose> poses = readPoseFile(job.poses);
    if (poses.front().time) return poses;
    throw std::runtime_error(
        job.poses.string() +
        ": has no times; poses beside a capture must be in TUM format: time tx "
        "ty tz qx qy qz qw");
}

/// One sensor of the capture.
struct Sensor
{
    std::string label;
    SensorClock clock;
    SweepAssembler sweeps;
    std::string lastSentence;
};

class VelodyneImporter
{
public:
    explicit VelodyneImporter(const VelodyneImport& job)
        : job_(job),
          capture_(job.capture),
          calibration_(calibrationOf(job)),
          writer_(job.output, timedPoses(job), job.poses)
    {
        if (!job.poses.empty()) summary_.poses = readPoseFile(job.poses).size();
    }

    VelodyneImportSummary run()
    {
        while (const auto packet = capture_.next())
        {
            Sensor& sensor = sensorOf(packet->sensor);
            const double time = sensor.clock.timeOf(*packet);
            if (packet->kind == VelodynePacket::Kind::Position)
                takePosition(sensor, *packet, time);
            else if (auto sweep = sensor.sweeps.add(*packet, time))
                write(sensor, std::move(*sweep), packet->sensor);
            if (summary_.stopped) return summary_;
        }
        for (auto& [address, sensor] : sensors_)
            if (auto sweep = sensor.sweeps.finish()) write(sensor, std::move(*sweep), address);
        finishSummary();
        if (!summary_.stopped) writer_.commit();
        return summary_;
    }

private:
    Sensor& sensorOf(std::uint32_t address)
    {
        const auto found = sensors_.find(address);
        if (found != sensors_.end()) return found->second;
        const std::string label =
            sensors_.empty() ? "velodyne" : "velodyne_" + std::to_string(sensors_.size() + 1);
        return sensors_.emplace(address, Sensor{label, {}, SweepAssembler(job_.cutAzimuth), {}})
            .first->second;
    }

    void takePosition(Sensor& sensor, const VelodynePacket& packet, double time)
    {
        constexpr std::size_t kSentenceAt = 206;
        constexpr double kLate = 3.0;  // s that a receiver takes to send what it has measured
        std::string sentence = packet.bytes.substr(kSentenceAt);
        sentence.resize(std::min(sentence.find('\0'), sentence.size()));
        if (sentence == sensor.lastSentence) return;
        sensor.lastSentence = sentence;
        const auto rmc = rmcIn(sentence);
        const auto gga = ggaIn(sentence);
        if (!rmc && !gga) return;
        const auto& utc = rmc ? rmc->fields.UTCTime : gga->fields.UTCTime;
        const double measured = sensor.clock.timeAt(utc.minute * 60.0 + utc.sec, time);
        if (std::abs(measured - time) < kLate) time = measured;
        mrpt::obs::CObservationGPS observation;
        observation.sensorLabel = sensors_.size() == 1 ? "gps" : "gps_of_" + sensor.label;
        observation.timestamp = mrpt::Clock::fromDouble(time);
        observation.originalReceivedTimestamp = mrpt::Clock::fromDouble(packet.time);
        observation.sensorPose = toPose3D(job_.sensorInVehicle);
        if (rmc) observation.setMsg(*rmc);
        if (gga) observation.setMsg(*gga);
        writer_.add(time, observation);
        ++summary_.gps;
    }

    void write(const Sensor& sensor, VelodyneScan scan, std::uint32_t address)
    {
        scan.sensorLabel = sensor.label;
        scan.sensorPose = toPose3D(job_.sensorInVehicle);
        const VelodyneModel model = modelOf(scan);
        scan.calibration = calibration_.empty() ? nominalCalibration(model) : calibration_;
        try
        {
            summary_.points += decodeVelodyne(scan).size();
        }
        catch (const std::runtime_error& error)
        {
            throw std::runtime_error(job_.capture.string() + ": " + error.what());
        }
        const double time = mrpt::Clock::toDouble(scan.timestamp);
        writer_.write(time, scan);
        if (summary_.scans++ == 0) firstTime_ = time;
        summary_.seconds = time - firstTime_;
        if (named_.insert({address, model}).second)
            summary_.sensors.push_back(sensor.label + ": " + nameOf(model) + " at " +
                                       addressText(address));
        const auto& progress = job_.output.progress;
        summary_.stopped = progress && !progress(summary_.scans, capture_.progress());
    }

    /// What the packets say, or what is asked for where they say nothing.
    VelodyneModel modelOf(const VelodyneScan& scan) const
    {
        VelodyneScan known = scan;
        if (!calibration_.empty()) known.calibration = calibration_;
        if (job_.model && calibration_.empty()) known.calibration = nominalCalibration(*job_.model);
        try
        {
            const VelodyneModel model = velodyneModelOf(known);
            if (job_.model && model != *job_.model)
                throw std::runtime_error("its packets are of the model " + nameOf(model) +
                                         ", not " + nameOf(*job_.model));
            if (model == VelodyneModel::HDL64E && calibration_.empty())
                throw std::runtime_error(
                    "an HDL-64E needs its own calibration: name its XML file with --calibration");
            return model;
        }
        catch (const std::runtime_error& error)
        {
            throw std::runtime_error(job_.capture.string() + ": " + error.what());
        }
    }

    void finishSummary()
    {
        summary_.capture = capture_.summary();
        for (const auto& [address, sensor] : sensors_)
            summary_.clockRestarts += sensor.clock.restarts();
        if (summary_.scans > 0) return;
        const CaptureSummary& c = summary_.capture;
        throw std::runtime_error(job_.capture.string() +
                                 ": no data packets of a Velodyne sensor among its " +
                                 std::to_string(c.packets) + " packets" +
                                 (c.problem.empty() ? "" : " (" + c.problem + ")"));
    }

    const VelodyneImport& job_;
    VelodyneCapture capture_;
    mrpt::obs::VelodyneCalibration calibration_;
    ImportWriter writer_;
    std::map<std::uint32_t, Sensor> sensors_;
    std::map<std::uint32_t, VelodyneModel> named_;
    double firstTime_ = 0.0;
    VelodyneImportSummary summary_;
};
}  // namespace

std::string nameOf(VelodyneModel model)
{
    switch (model)
    {
        case VelodyneModel::VLP16:
            return "VLP-16";
        case VelodyneModel::HDL32E:
            return "HDL-32E";
        case VelodyneModel::HDL64E:
            return "HDL-64E";
    }
    return {};
}

void checkPaths(const VelodyneImport& job)
{
    checkOutputPaths({job.output.rawlog}, {{job.capture, "the capture"},
                                           {job.calibration, "the calibration"},
                                           {job.poses, "the file of poses"}});
}

VelodyneImportSummary importVelodyne(const VelodyneImport& job)
{
    checkPaths(job);
    return VelodyneImporter(job).run();
}

}  // namespace vdamf
