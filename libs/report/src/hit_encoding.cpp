// SPDX-License-Identifier: BSD-3-Clause
#include "hit_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vdamf
{
namespace
{
using Centimetres = std::array<std::uint16_t, 3>;  // two's complement

std::uint16_t quantised(float metres)
{
    constexpr float kLargest = 32767.0F;
    const float centimetres = std::clamp(std::round(100.0F * metres), -kLargest, kLargest);
    return static_cast<std::uint16_t>(static_cast<std::int16_t>(centimetres));
}

/// Every second bit free.
std::uint32_t spread(std::uint32_t v)
{
    v = (v | v << 8U) & 0x00FF00FFU;
    v = (v | v << 4U) & 0x0F0F0F0FU;
    v = (v | v << 2U) & 0x33333333U;
    return (v | v << 1U) & 0x55555555U;
}

std::uint32_t mortonCode(const Centimetres& p)
{
    constexpr std::uint32_t kMiddle = 0x8000U;  // negative coordinates before positive ones
    return spread(p[0] ^ kMiddle) | spread(p[1] ^ kMiddle) << 1U;
}

std::vector<Centimetres> ordered(const HitPositions& hits)
{
    std::vector<Centimetres> all;
    all.reserve(hits.size());
    for (const Eigen::Vector3f& p : hits)
        all.push_back({quantised(p.x()), quantised(p.y()), quantised(p.z())});
    std::sort(all.begin(), all.end(),
              [](const Centimetres& a, const Centimetres& b)
              {
                  const std::uint32_t codeA = mortonCode(a);
                  const std::uint32_t codeB = mortonCode(b);
                  return codeA != codeB ? codeA < codeB : a < b;
              });
    return all;
}

void append(std::string& bytes, std::uint32_t value)
{
    for (const unsigned shift : {0U, 8U, 16U, 24U})
        bytes += static_cast<char>(value >> shift & 0xFFU);
}

void appendPlanes(std::string& bytes, const std::vector<Centimetres>& hits, std::size_t axis)
{
    std::string low;
    std::string high;
    std::uint16_t before = 0;
    for (const Centimetres& p : hits)
    {
        const auto difference = static_cast<std::uint16_t>(p[axis] - before);
        before = p[axis];
        low += static_cast<char>(difference & 0xFFU);
        high += static_cast<char>(difference >> 8U);
    }
    bytes += low + high;
}
}  // namespace

std::string encoded(const ShownHits& shown)
{
    std::vector<Centimetres> all;
    std::string bytes;
    append(bytes, static_cast<std::uint32_t>(3 + shown.clusters.size()));
    const auto add = [&](const HitPositions& hits, std::uint64_t track)
    {
        append(bytes, static_cast<std::uint32_t>(hits.size()));
        append(bytes, static_cast<std::uint32_t>(track));
        const std::vector<Centimetres> more = ordered(hits);
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const HitPositions* hits : {&shown.ground, &shown.overhead, &shown.structure})
        add(*hits, 0);
    for (const ShownCluster& cluster : shown.clusters) add(cluster.hits, cluster.track);
    for (const std::size_t axis : {0U, 1U, 2U}) appendPlanes(bytes, all, axis);
    return bytes;
}

}  // namespace vdamf
