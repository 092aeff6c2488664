// SPDX-License-Identifier: BSD-3-Clause
// The kinds of simulated objects: road users, and clutter.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class ObjectClass
{
    Car,  ///< three boxes: bonnet, cabin, boot
    Hatchback,
    Suv,
    Van,
    Truck,    ///< rigid, with a cab and a box
    Trailer,  ///< of a truck, without its drawbar
    Bus,
    Tram,
    Motorcycle,  ///< with its rider where it is 1.35 m high or more
    Bicycle,     ///< with its rider where it is 1.35 m high or more
    Pedestrian,
    Bush,
    Tree,
    Pole,
    Wall,
    GuardRail,
    Sign,
    Box
};

template <>
struct EnumNames<ObjectClass>
{
    static std::vector<std::pair<ObjectClass, const char*>> names();
};

/// Car to Tram: what the tracker is to report as a vehicle.
bool isVehicle(ObjectClass objectClass);

/// The class in truth.csv; nothing for clutter. A trailer is an object of its own, a Truck; two
/// wheels are a Cyclist, with or without a motor or a rider.
std::optional<const char*> truthClass(ObjectClass objectClass);

struct BodySize
{
    double length = 0.0;  ///< along the heading, m
    double width = 0.0;   ///< m
    double height = 0.0;  ///< m
};

/// A usual size of the class.
BodySize typicalSize(ObjectClass objectClass);

/// Smaller ones have no room for the profile.
BodySize leastSizeOf(ObjectClass objectClass);

/// As in a scenario file.
std::string nameOf(ObjectClass objectClass);

/// From the box's centre back to the point that moves along the heading: the rear axle of what
/// has wheels, 0 for all else, m.
double rearAxleOffsetOf(ObjectClass objectClass, double length);

}  // namespace vdamf
