// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/simulation/object_class.h"

namespace vdamf
{
std::vector<std::pair<ObjectClass, const char*>> EnumNames<ObjectClass>::names()
{
    return {{ObjectClass::Car, "car"},
            {ObjectClass::Hatchback, "hatchback"},
            {ObjectClass::Suv, "suv"},
            {ObjectClass::Van, "van"},
            {ObjectClass::Truck, "truck"},
            {ObjectClass::Trailer, "trailer"},
            {ObjectClass::Bus, "bus"},
            {ObjectClass::Tram, "tram"},
            {ObjectClass::Motorcycle, "motorcycle"},
            {ObjectClass::Bicycle, "bicycle"},
            {ObjectClass::Pedestrian, "pedestrian"},
            {ObjectClass::Bush, "bush"},
            {ObjectClass::Tree, "tree"},
            {ObjectClass::Pole, "pole"},
            {ObjectClass::Wall, "wall"},
            {ObjectClass::GuardRail, "guard_rail"},
            {ObjectClass::Sign, "sign"},
            {ObjectClass::Box, "box"}};
}

bool isVehicle(ObjectClass objectClass)
{
    return objectClass <= ObjectClass::Tram;
}

std::optional<const char*> truthClass(ObjectClass objectClass)
{
    switch (objectClass)
    {
        case ObjectClass::Car:
        case ObjectClass::Hatchback:
        case ObjectClass::Suv:
            return "Car";
        case ObjectClass::Van:
            return "Van";
        case ObjectClass::Truck:
        case ObjectClass::Trailer:
            return "Truck";
        case ObjectClass::Bus:
            return "Bus";
        case ObjectClass::Tram:
            return "Tram";
        case ObjectClass::Motorcycle:
        case ObjectClass::Bicycle:
            return "Cyclist";
        case ObjectClass::Pedestrian:
            return "Pedestrian";
        default:
            return std::nullopt;
    }
}

BodySize typicalSize(ObjectClass objectClass)
{
    switch (objectClass)
    {
        case ObjectClass::Car:
            return {4.5, 1.8, 1.5};
        case ObjectClass::Hatchback:
            return {4.1, 1.78, 1.48};
        case ObjectClass::Suv:
            return {4.6, 1.88, 1.7};
        case ObjectClass::Van:
            return {5.4, 2.0, 2.1};
        case ObjectClass::Truck:
            return {9.0, 2.5, 3.3};
        case ObjectClass::Trailer:
            return {8.0, 2.5, 3.6};
        case ObjectClass::Bus:
            return {12.0, 2.55, 3.1};
        case ObjectClass::Tram:
            return {25.0, 2.4, 3.4};
        case ObjectClass::Motorcycle:
            return {2.2, 0.8, 1.6};
        case ObjectClass::Bicycle:
            return {1.8, 0.6, 1.75};
        case ObjectClass::Pedestrian:
            return {0.6, 0.6, 1.75};
        case ObjectClass::Bush:
            return {2.0, 1.5, 1.2};
        case ObjectClass::Tree:
            return {4.0, 4.0, 7.0};
        case ObjectClass::Pole:
            return {0.2, 0.2, 5.0};
        case ObjectClass::Wall:
            return {20.0, 0.3, 2.0};
        case ObjectClass::GuardRail:
            return {20.0, 0.3, 0.75};
        case ObjectClass::Sign:
            return {0.1, 0.75, 2.6};
        case ObjectClass::Box:
            return {1.0, 1.0, 1.0};
    }
    return {1.0, 1.0, 1.0};
}

BodySize leastSizeOf(ObjectClass objectClass)
{
    switch (objectClass)
    {
        case ObjectClass::Truck:
        case ObjectClass::Bus:
        case ObjectClass::Tram:
            return {4.0, 1.5, 1.8};
        case ObjectClass::Trailer:
            return {2.5, 1.5, 1.6};
        case ObjectClass::Motorcycle:
        case ObjectClass::Bicycle:
            return {1.0, 0.2, 0.6};
        case ObjectClass::Pedestrian:
            return {0.2, 0.2, 0.5};
        default:
            return isVehicle(objectClass) ? BodySize{2.0, 1.0, 1.0} : BodySize{};
    }
}

std::string nameOf(ObjectClass objectClass)
{
    for (const auto& [value, name] : EnumNames<ObjectClass>::names())
    {
        if (value == objectClass) return name;
    }
    return "";
}

double rearAxleOffsetOf(ObjectClass objectClass, double length)
{
    switch (objectClass)
    {
        case ObjectClass::Car:
        case ObjectClass::Hatchback:
        case ObjectClass::Suv:
        case ObjectClass::Van:
            return 0.28 * length;
        case ObjectClass::Truck:
        case ObjectClass::Bus:
            return 0.22 * length;
        case ObjectClass::Trailer:
            return 0.05 * length;
        case ObjectClass::Tram:
        case ObjectClass::Motorcycle:
        case ObjectClass::Bicycle:
            return 0.3 * length;
        default:
            return 0.0;
    }
}

}  // namespace vdamf
