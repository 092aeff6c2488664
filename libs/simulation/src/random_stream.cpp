// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same with every standard library.
#include "vdamf/simulation/random_stream.h"

#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
/// SplitMix64's finaliser (Steele, Lea, Flood 2014): neighbouring inputs give unrelated outputs.
std::uint64_t scrambled(std::uint64_t value)
{
    value += 0x9e3779b97f4a7c15ULL;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
    return value ^ (value >> 31);
}
}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t index)
    : engine_(scrambled(scrambled(seed) + index))
{
}

double RandomStream::uniform()
{
    return static_cast<double>(engine_() >> 11) * 0x1.0p-53;
}

double RandomStream::gaussian()
{
    // Box-Muller; its second value is not kept, so that the stream has no hidden state.
    const double radius = std::sqrt(exponential(2.0));
    return radius * std::cos(2.0 * kPi * uniform());
}

double RandomStream::exponential(double mean)
{
    return -mean * std::log1p(-uniform());
}

}  // namespace vdamf
