// SPDX-License-Identifier: BSD-3-Clause
// How bright vehicles are.
#include "vdamf/simulation/paint.h"

#include <cmath>

#include "vdamf/simulation/random_stream.h"

namespace vdamf
{
double paintReflectivity(double share)
{
    constexpr double kBlack = 0.015;
    constexpr double kWhite = 0.4;
    return kBlack * std::pow(kWhite / kBlack, share);
}

double paintOf(std::string_view name)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
    for (const char letter : name)
    {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
    }
    return paintReflectivity(RandomStream(hash, 0).uniform());
}

}  // namespace vdamf
