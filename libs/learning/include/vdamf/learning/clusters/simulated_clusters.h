// SPDX-License-Identifier: BSD-3-Clause
// Simulated clusters: what an HDL-32E on a roof sees of one vehicle, 8 to 60 m away.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vdamf/learning/clusters/labelled_cluster.h"
#include "vdamf/simulation/body.h"

namespace vdamf
{
struct SimulatedKind
{
    enum class Aspect
    {
        Any,
        End,       ///< the sensor straight ahead or behind: one end alone in view
        Side,      ///< the sensor abreast: one side alone in view
        Neighbour  ///< one lane beside, up to 30 m ahead or behind: a side at a grazing angle
    };

    std::string name;
    std::string description;
    ObjectClass body = ObjectClass::Box;  ///< Box: upright walls from the ground up
    double rangeNoise = 0.03;             ///< standard deviation, m
    double clutter = 0.0;                 ///< share of hits anywhere up to 1 m around the box
    bool bush = false;                    ///< 0.3 to 0.6 m beside a face
    bool mirrors = false;
    bool hidden = false;  ///< 30 to 60 % of the view, from one end on
    Aspect aspect = Aspect::Any;
};

/// All kinds, in the order of the tables.
std::vector<SimulatedKind> simulatedKinds();

/// `count` samples of at least ten hits each; the same for the same seed.
LabelledClusters simulatedCondition(const SimulatedKind& kind, int count, std::uint64_t seed);

}  // namespace vdamf
