// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/ins_trajectory.h"

#include <mrpt/obs/CSensoryFrame.h>

#include "ins_reading.h"
#include "ins_sensor.h"

namespace vdamf
{
struct InsTrajectory::Impl
{
    explicit Impl(const InsOptions& o) : source(o.source), robotPose(o), gps(o) {}

    InsSource source;  // Auto until the first question that can be answered
    InsSensor robotPose;
    InsSensor gps;

    void insert(const mrpt::obs::CObservation& observation)
    {
        const auto reading = insReading(observation);
        if (!reading) return;
        const bool isPose = reading->grade == InsReading::Grade::RobotPose;
        if (source == (isPose ? InsSource::Gps : InsSource::RobotPose)) return;
        (isPose ? robotPose : gps).insert(observation.sensorLabel, *reading);
    }

    /// The source, as far as it is known.
    const InsSensor& chosen() const
    {
        if (source == InsSource::RobotPose) return robotPose;
        if (source == InsSource::Gps) return gps;
        return robotPose.samples().empty() ? gps : robotPose;
    }

    void choose()
    {
        if (chosen().samples().empty()) return;
        source = &chosen() == &robotPose ? InsSource::RobotPose : InsSource::Gps;
        (source == InsSource::Gps ? gps : robotPose).fix();
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

std::optional<VehiclePose> InsTrajectory::at(double time) const
{
    impl_->choose();
    return impl_->chosen().samples().at(time);
}

bool InsTrajectory::covers(double time) const
{
    return impl_->chosen().samples().covers(time);
}

void InsTrajectory::forgetBefore(double time)
{
    impl_->robotPose.forgetBefore(time);
    impl_->gps.forgetBefore(time);
}

std::string InsTrajectory::sourceName() const
{
    return impl_->chosen().name();
}
std::string InsTrajectory::originText() const
{
    return impl_->chosen().originText();
}
std::size_t InsTrajectory::samplesTaken() const
{
    return impl_->chosen().taken();
}
std::size_t InsTrajectory::samplesDropped() const
{
    // As long as no source is chosen, either could have been it.
    if (impl_->source == InsSource::Auto) return impl_->robotPose.dropped() + impl_->gps.dropped();
    return impl_->chosen().dropped();
}

}  // namespace vdamf
