// SPDX-License-Identifier: BSD-3-Clause
// Vehicles as they are known, and as they are measured.
#pragma once

#include <initializer_list>

#include "vdamf/tracking/types/measurement.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
inline Measurement measured(const OrientedBox& box, FaceSet faces)
{
    Measurement m;
    m.box = box;
    m.covariance = (Vector5d() << 1e-4, 1e-4, 1e-5, 1e-3, 1e-3).finished().asDiagonal();
    m.facesSeen = faces;
    m.hits = 100;
    return m;
}

inline FaceSet faces(std::initializer_list<Face> list)
{
    FaceSet set;
    for (const Face f : list) set.add(f);
    return set;
}

inline VehicleState known(const OrientedBox& box, double lengthSigma)
{
    VehicleState s;
    s.mean << box.x, box.y, box.heading, 5.0, 0.0, 1.2, box.length;
    s.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.1, 1e-4, 0.1, lengthSigma * lengthSigma;
    s.width = box.width;
    s.widthVariance = 0.01;
    return s;
}

}  // namespace vdamf
