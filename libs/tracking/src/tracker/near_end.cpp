// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/near_end.h"

#include "types/box_changes.h"

namespace vdamf
{
Measurement withNearEndOfRow(const Sighting& sighting)
{
    constexpr double kBeyond = 0.2;  // m
    constexpr double kSigma = 0.15;  // m: corners are round
    Measurement m = sighting.measurement;
    if (!m.facesSeen.seesSide()) return m;
    const FaceRow& row = sighting.side;
    const double near = toBoxFrame(m.box, sighting.sensor).x() > 0.0 ? 1.0 : -1.0;
    const double beyond = near * row.middle + 0.5 * row.metres - 0.5 * m.box.length;
    if (beyond < kBeyond) return m;
    const Eigen::Vector2d shift = 0.5 * near * beyond * rotation(m.box.heading).col(0);
    m.box.x += shift.x();
    m.box.y += shift.y();
    m.box.length += beyond;
    m.facesSeen.remove(near > 0.0 ? Face::Front : Face::Back);
    const Vector5d change = byFace(rotation(m.box.heading), 0, near > 0.0 ? 1 : 0);
    m.covariance += kSigma * kSigma * change * change.transpose();
    return m;
}

}  // namespace vdamf
