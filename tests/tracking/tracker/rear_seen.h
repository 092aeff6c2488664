// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "tracking/tracker/seen_as.h"

namespace vdamf
{
/// A car 20 m ahead whose rear shows a row of some metres on its left half.
inline Sighting rearSeen(double metres)
{
    Sighting s;
    s.measurement.box = {22.25, 0.0, 0.0, 4.5, 1.8};
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.01, 0.01;
    s.end.metres = metres;
    s.height = 1.5;
    s.around = {20.05, 0.9 - 0.5 * metres, 0.0, 0.1, metres};
    return s;
}

/// Of a place on the box, m^2, along x.
inline double varianceAt(const Measurement& m, double x, double y)
{
    Vector5d byBox = Vector5d::Zero();
    byBox.head<3>() << 1.0, 0.0, -(y - m.box.y);
    byBox(3) = (x - m.box.x) / m.box.length;
    return byBox.dot(m.covariance * byBox);
}

inline HitsAtOneTime hitsOnRear(double lowest)
{
    Cluster hits;
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 10; ++k)
        {
            hits.x.push_back(20.0F);
            hits.y.push_back(-0.9F + 0.2F * static_cast<float>(k));
            hits.height.push_back(static_cast<float>(lowest + 0.15 * row));
        }
    return seenAs(std::move(hits));
}

}  // namespace vdamf
