// SPDX-License-Identifier: BSD-3-Clause
// The hits along the two faces towards the sensor.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// Hits near a face, in blocks for many at a time. Weight 0 fills the last block.
struct FaceHits
{
    struct Block
    {
        static constexpr int kHits = 16;
        std::array<float, kHits> outwards{};  ///< from the middle of the box, m
        std::array<float, kHits> along{};     ///< the face, from there, m
        std::array<float, kHits> weight{};
        std::array<float, kHits> spread{};  ///< of a centre's hits, outwards, m^2
    };
    std::vector<Block> blocks;
    int inLast = Block::kHits;  ///< used of the last block

    void add(double outwards, double along, double weight, double spread)
    {
        if (inLast == Block::kHits)
        {
            blocks.emplace_back();
            inLast = 0;
        }
        Block& block = blocks.back();
        const auto k = static_cast<std::size_t>(inLast++);
        block.outwards[k] = static_cast<float>(outwards);
        block.along[k] = static_cast<float>(along);
        block.weight[k] = static_cast<float>(weight);
        block.spread[k] = static_cast<float>(spread);
    }

    void add(const FaceHits& others)
    {
        for (const Block& block : others.blocks)
            for (std::size_t k = 0; k < Block::kHits; ++k)
                if (block.weight[k] > 0.0F)
                    add(block.outwards[k], block.along[k], block.weight[k], block.spread[k]);
    }

    bool empty() const { return blocks.empty(); }
};

/// One of the two faces towards the sensor, or a part of it.
struct NearFace
{
    FaceHits hits;
    double weight = 0.0;  ///< of all hits
    double sign = 1.0;    ///< +1 where it lies at the positive end of its axis
    double slope = 1.0;   ///< d outwards / d turn of a hit, over its place along
    double noise = 0.0;   ///< of the sensor, across the face, m
};

/// What of the hits lies on a face.
struct NearFaceOptions
{
    double gate = 0.35;       ///< hits farther from a face are not on it, m
    double corner = 0.25;     ///< along a face from the corner of both: bumpers are round there, m
    double rangeNoise = 0.0;  ///< of the sensor, standard deviation, m
    double minHits = 4.0;     ///< fewer are none
};

/// The end and the side; and of cars what of the side is above the belt, where it lies farther
/// inside: it shows the same direction.
using NearFaces = std::array<NearFace, 3>;
inline constexpr std::size_t kEndFace = 0;
inline constexpr std::size_t kSideFace = 1;
inline constexpr std::size_t kUpperSide = 2;

/// Of the faces `seen` of a box; a hit near both is on neither, and one on the roof of a car is not
/// on its side. Where the side has few hits above its belt, or below it, they are together.
NearFaces nearFaces(const Hits& hits, const OrientedBox& box, FaceSet seen,
                    const Eigen::Vector2d& sensor, const NearFaceOptions& options);

}  // namespace vdamf
