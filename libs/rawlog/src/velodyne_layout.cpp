// SPDX-License-Identifier: BSD-3-Clause
#include "velodyne_layout.h"

#include <cmath>
#include <stdexcept>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
// -15, 1, -13, 3, ..., -1, 15 degrees (VLP-16 user manual).
std::vector<double> elevationsVlp16()
{
    std::vector<double> result;
    for (int i = 0; i < 8; ++i)
    {
        result.push_back((-15.0 + 2.0 * i) * kDegree);
        result.push_back((1.0 + 2.0 * i) * kDegree);
    }
    return result;
}

// -30.67, -9.33, -29.33, -8.00, ..., -10.67, 10.67 degrees, as the HDL-32E manual rounds them.
std::vector<double> elevationsHdl32e()
{
    std::vector<double> result;
    for (int i = 0; i < 16; ++i)
    {
        for (const double start : {-92.0, -28.0})
        {
            const double degrees = (start + 4.0 * i) / 3.0;
            result.push_back(std::round(degrees * 100.0) / 100.0 * kDegree);
        }
    }
    return result;
}

// Nominal: 2 to -8.33 degrees in steps of 1/3, then -8.83 to -24.33 in steps of 1/2. A real
// sensor has its lasers in another order and comes with its calibration.
std::vector<double> elevationsHdl64e()
{
    std::vector<double> result;
    for (int i = 0; i < 32; ++i) result.push_back((2.0 - i / 3.0) * kDegree);
    for (int i = 0; i < 32; ++i) result.push_back((-8.83 - i / 2.0) * kDegree);
    return result;
}
}  // namespace

VelodyneLayout velodyneLayout(VelodyneModel model)
{
    switch (model)
    {
        case VelodyneModel::VLP16:
            return {16, 2, 1, 55.296e-6, 2.304e-6};
        case VelodyneModel::HDL32E:
            return {32, 1, 1, 46.08e-6, 1.152e-6};
        case VelodyneModel::HDL64E:
            // 64 shots in 48 us, two at a time; the groups of four of the manual are spread evenly
            // (1 us of difference, 0.01 mm at road speed).
            return {64, 1, 2, 48.0e-6, 1.5e-6};
    }
    throw std::logic_error("velodyneLayout: unknown model");
}

const std::vector<double>& laserElevations(VelodyneModel model)
{
    static const std::vector<double> vlp16 = elevationsVlp16();
    static const std::vector<double> hdl32e = elevationsHdl32e();
    static const std::vector<double> hdl64e = elevationsHdl64e();
    switch (model)
    {
        case VelodyneModel::VLP16:
            return vlp16;
        case VelodyneModel::HDL32E:
            return hdl32e;
        case VelodyneModel::HDL64E:
            return hdl64e;
    }
    throw std::logic_error("laserElevations: unknown model");
}

}  // namespace vdamf
