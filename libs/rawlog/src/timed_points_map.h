// SPDX-License-Identifier: BSD-3-Clause
// Points with rings and times, as MRPT has them from 2.11.5 on.
#pragma once

#include <mrpt/maps/CPointsMapXYZI.h>

#include <cstdint>
#include <vector>

namespace vdamf
{
/// Stands in for mrpt::maps::CPointsMapXYZIRT of newer versions in the classes that MRPT can read,
/// so that their clouds are not unknown. Intensities, rings and times may each be missing.
class TimedPointsMap : public mrpt::maps::CPointsMapXYZI
{
public:
    /// Makes the class known to MRPT, where MRPT does not have it itself.
    static void registerClass();

    bool hasIntensities() const { return hasIntensities_; }
    /// s relative to the observation's time; empty: none.
    const std::vector<float>& times() const { return times_; }

    const mrpt::rtti::TRuntimeClassId* GetRuntimeClass() const override;
    mrpt::rtti::CObject* clone() const override { return new TimedPointsMap(*this); }

protected:
    std::uint8_t serializeGetVersion() const override { return 0; }
    void serializeTo(mrpt::serialization::CArchive& out) const override;
    void serializeFrom(mrpt::serialization::CArchive& in, std::uint8_t version) override;

private:
    bool hasIntensities_ = false;
    std::vector<std::uint16_t> rings_;
    std::vector<float> times_;
};

}  // namespace vdamf
