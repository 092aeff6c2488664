// SPDX-License-Identifier: BSD-3-Clause
// Sections 4.1 and 4.2: the matched filter's response to a set of hits, analytic, with its exact
// gradient and Hessian.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vdamf/tracking/matched_filter/filter_shape.h"
#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// Value and derivatives of M of Eq. (10) in the parameters (t_x, t_y, t_theta, l, w).
///
/// t_x and t_y are offsets of the box centre from its current position along the axes of the
/// turned box (Eq. 9 with m_0 at the current centre): at t = 0 the centre in the plane moves by
/// R(theta) (t_x, t_y).
struct MatchResponse
{
    double value = 0.0;  ///< M, hits / m
    Vector5d gradient = Vector5d::Zero();
    Matrix5d hessian = Matrix5d::Zero();
};

/// Sensor angle beta = theta - phi, with phi the bearing from the box centre to the sensor. phi is
/// held constant during an optimisation (4.2).
double bearingToSensor(const OrientedBox& box, const Eigen::Vector2d& sensor);

/// M alone (Eq. 10). Box in the frame of the hits; phi in rad.
double matchValue(const Hits& hits, const FilterShape& shape, const OrientedBox& box, double phi);

/// M with gradient and Hessian.
MatchResponse matchResponse(const Hits& hits, const FilterShape& shape, const OrientedBox& box,
                            double phi);

/// The response with what each hit adds to it.
struct ResponseByHit
{
    MatchResponse all;
    /// Eq. (13) for every hit: the derivative of the gradient of M by the hit's position along the
    /// axes of the box, for one hit of the centre's weight.
    std::vector<Eigen::Matrix<double, 5, 2>> gradientByHit;
};

ResponseByHit responseByHit(const Hits& hits, const FilterShape& shape, const OrientedBox& box,
                            double phi);

/// Eq. (3) without the root: the integral of the squared filter, m^2 (for tests and baselines).
double filterEnergy(const FilterShape& shape, const OrientedBox& box, double phi);

/// The filter's height s at a point of the plane given in box coordinates (for tests and plots).
double filterHeight(const FilterShape& shape, const OrientedBox& box, double phi,
                    const Eigen::Vector2d& pointInBox);

}  // namespace vdamf
