// SPDX-License-Identifier: BSD-3-Clause
// Types of vehicles that filters are learned for.
#pragma once

#include <optional>
#include <string>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class VehicleType
{
    Any,  ///< one filter serves all
    Car,
    Van,
    Truck,  ///< and buses
    TwoWheeler
};

template <>
struct EnumNames<VehicleType>
{
    static std::vector<std::pair<VehicleType, const char*>> names()
    {
        return {{VehicleType::Any, "any"},
                {VehicleType::Car, "car"},
                {VehicleType::Van, "van"},
                {VehicleType::Truck, "truck"},
                {VehicleType::TwoWheeler, "two_wheeler"}};
    }
};

const char* toString(VehicleType type);
std::optional<VehicleType> vehicleTypeFromString(const std::string& text);

/// The most likely type of a track.
struct TypeProbability
{
    VehicleType type = VehicleType::Any;
    double probability = 0.0;
};

}  // namespace vdamf
