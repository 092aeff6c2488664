// SPDX-License-Identifier: BSD-3-Clause
// What surfaces are made of, as far as a LADAR notices.
#pragma once

#include <cstdint>

namespace vdamf
{
enum class Material : std::uint8_t
{
    Asphalt,
    Paint,
    Glass,
    Rubber,
    Foliage,
    Wood,
    Metal,
    Concrete,
    Cloth,
    Reflector
};

/// Share of the light that a matt surface of this material sends back, 0..1. Also the intensity
/// of its hits: few levels, as in the calibrated intensities of real sensors.
constexpr double reflectivity(Material material)
{
    switch (material)
    {
        case Material::Asphalt:
            return 0.15;
        case Material::Paint:
            return 0.50;
        case Material::Glass:
            return 0.10;
        case Material::Rubber:
            return 0.05;
        case Material::Foliage:
            return 0.40;
        case Material::Wood:
            return 0.30;
        case Material::Metal:
            return 0.60;
        case Material::Concrete:
            return 0.35;
        case Material::Cloth:
            return 0.30;
        case Material::Reflector:
            return 0.95;
    }
    return 0.0;
}

}  // namespace vdamf
