// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/vehicle_type.h"

namespace vdamf
{
const char* toString(VehicleType type)
{
    switch (type)
    {
        case VehicleType::Any:
            break;
        case VehicleType::Car:
            return "car";
        case VehicleType::Van:
            return "van";
        case VehicleType::Truck:
            return "truck";
        case VehicleType::TwoWheeler:
            return "two_wheeler";
    }
    return "any";
}

std::optional<VehicleType> vehicleTypeFromString(const std::string& text)
{
    for (const auto& [type, name] : EnumNames<VehicleType>::names())
        if (text == name) return type;
    return std::nullopt;
}

}  // namespace vdamf
