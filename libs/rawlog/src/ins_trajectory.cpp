// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/ins_trajectory.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "first_labels.h"
#include "imu_attitudes.h"
#include "ins_reading.h"
#include "ins_sensor.h"

namespace vdamf
{
namespace
{
/// The source that a reading belongs to.
InsSource sourceOf(const InsReading& reading)
{
    switch (reading.grade)
    {
        case InsReading::Grade::RobotPose:
            return InsSource::RobotPose;
        case InsReading::Grade::Odometry:
            return InsSource::Odometry;
        case InsReading::Grade::Movement:
            return InsSource::Actions;
        default:
            return InsSource::Gps;
    }
}

constexpr InsSource kInOrder[] = {InsSource::RobotPose, InsSource::Gps, InsSource::Odometry,
                                  InsSource::Actions};
}  // namespace

struct InsTrajectory::Impl
{
    explicit Impl(const InsOptions& o)
        : options(o),
          source(o.source),
          imu(std::make_shared<ImuAttitudes>(o)),
          robotPose(o),
          gps(o, o.gpsHeading == GpsHeading::Course ? nullptr : imu),
          odometry(o),
          actions(o)
    {
    }

    InsOptions options;
    InsSource source;  // Auto until the first question that can be answered
    std::shared_ptr<ImuAttitudes> imu;
    InsSensor robotPose;
    InsSensor gps;
    InsSensor odometry;
    InsSensor actions;
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();  // by all actions
    bool movementWaits = false;                               // for a time
    std::vector<std::string> labels;

    InsSensor& of(InsSource one)
    {
        switch (one)
        {
            case InsSource::RobotPose:
                return robotPose;
            case InsSource::Odometry:
                return odometry;
            case InsSource::Actions:
                return actions;
            default:
                return gps;
        }
    }
    const InsSensor& of(InsSource one) const { return const_cast<Impl*>(this)->of(one); }

    void insert(const mrpt::obs::CObservation& observation)
    {
        if (movementWaits && observation.timestamp != INVALID_TIMESTAMP)
            insertMoved(mrpt::Clock::toDouble(observation.timestamp));
        if (const auto* one = dynamic_cast<const mrpt::obs::CObservationIMU*>(&observation))
            imu->insert(*one);
        if (const auto reading = insReading(observation)) insert(observation.sensorLabel, *reading);
    }

    void insert(const std::string& label, const InsReading& reading)
    {
        const InsSource from = sourceOf(reading);
        if (source != InsSource::Auto && source != from) return;
        addLabel(labels, label);
        of(from).insert(label, reading);
    }

    void insert(const VehicleMovement& movement)
    {
        moved = moved * movement.change;
        movementWaits = !movement.time;
        if (movement.time) insertMoved(*movement.time);
    }

    /// The pose that the actions have led to.
    void insertMoved(double time)
    {
        movementWaits = false;
        InsReading reading;
        reading.grade = InsReading::Grade::Movement;
        reading.sample.time = time;
        reading.sample.position = moved.translation();
        reading.sample.attitude = Eigen::Quaterniond(moved.linear());
        reading.valid = moved.matrix().allFinite();
        insert(options.label, reading);
    }

    /// The source, as far as it is known.
    InsSource likely() const
    {
        if (source != InsSource::Auto) return source;
        for (const InsSource one : kInOrder)
            if (!of(one).samples().empty()) return one;
        return InsSource::Gps;
    }
    const InsSensor& chosen() const { return of(likely()); }

    void choose()
    {
        if (source == InsSource::Standing || chosen().samples().empty()) return;
        source = likely();
        of(source).fix();
    }
};

InsTrajectory::InsTrajectory(InsOptions options) : impl_(std::make_unique<Impl>(options)) {}
InsTrajectory::~InsTrajectory() = default;
InsTrajectory::InsTrajectory(InsTrajectory&&) noexcept = default;
InsTrajectory& InsTrajectory::operator=(InsTrajectory&&) noexcept = default;

void InsTrajectory::insert(const mrpt::serialization::CSerializable& object)
{
    if (const auto* observation = dynamic_cast<const mrpt::obs::CObservation*>(&object))
    {
        impl_->insert(*observation);
    }
    if (const auto* frame = dynamic_cast<const mrpt::obs::CSensoryFrame*>(&object))
    {
        for (const auto& observation : *frame)
        {
            if (observation) impl_->insert(*observation);
        }
    }
}

void InsTrajectory::insert(const VehicleMovement& movement)
{
    impl_->insert(movement);
}

std::optional<VehiclePose> InsTrajectory::at(double time) const
{
    if (impl_->source == InsSource::Standing)
    {
        VehiclePose pose;
        pose.time = time;
        return pose;
    }
    impl_->choose();
    return impl_->chosen().samples().at(time);
}

bool InsTrajectory::covers(double time) const
{
    return impl_->source == InsSource::Standing || impl_->chosen().samples().covers(time);
}

void InsTrajectory::forgetBefore(double time)
{
    for (const InsSource one : kInOrder) impl_->of(one).forgetBefore(time);
    impl_->imu->forgetBefore(time);
}

std::string InsTrajectory::sourceName() const
{
    if (impl_->source == InsSource::Standing) return "none, standing";
    const InsSensor& sensor = impl_->chosen();
    const bool withImu = sensor.lacksAttitude() && !impl_->imu->name().empty() &&
                         impl_->options.gpsHeading != GpsHeading::Course;
    return sensor.name() + (withImu ? " with " + impl_->imu->name() : "");
}
std::string InsTrajectory::originText() const
{
    return impl_->source == InsSource::Standing ? "the vehicle" : impl_->chosen().originText();
}
std::size_t InsTrajectory::samplesTaken() const
{
    return report().taken;
}
std::size_t InsTrajectory::samplesDropped() const
{
    return report().duplicates + report().impossible;
}

InsReport InsTrajectory::report() const
{
    InsReport report = impl_->chosen().report();
    report.labels = impl_->labels;
    // As long as no source is chosen, any could have been it.
    if (impl_->source == InsSource::Auto)
        for (const InsSource one : kInOrder)
            if (one != impl_->likely()) report.impossible += impl_->of(one).report().impossible;
    return report;
}

}  // namespace vdamf
