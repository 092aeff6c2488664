// SPDX-License-Identifier: BSD-3-Clause
// How bright vehicles are at the wavelength of LADARs (905 nm).
#pragma once

#include <string_view>

namespace vdamf
{
/// Reflectivity of paint for a uniformly distributed share in 0..1: log-uniform from 0.015 (black
/// clear coat) to 0.4. With these, simulated HDL-64E scans have as many hits on parked cars of
/// KITTI, near and far, as the recorded ones.
double paintReflectivity(double share);

/// The paint of the object of this name: always the same, whatever the seed.
double paintOf(std::string_view name);

}  // namespace vdamf
