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
    const FaceRow& row = sighting.side;
    if (!m.facesSeen.seesSide() || row.hits == 0.0) return m;
    const int end = toBoxFrame(m.box, sighting.sensor).x() > 0.0 ? 1 : 0;
    const double near = signOfEnd(end);
    const double begins = near * toBoxFrame(m.box, row.middle).x() + 0.5 * row.metres;
    const double beyond = begins - 0.5 * m.box.length;
    if (beyond < kBeyond) return m;
    const Vector5d change = byFace(rotation(m.box.heading), 0, end);
    m.box.x += near * beyond * change(0);
    m.box.y += near * beyond * change(1);
    m.box.length += beyond;
    m.facesSeen.remove(kFaceAt[0][end]);
    m.covariance += kSigma * kSigma * change * change.transpose();
    return m;
}

}  // namespace vdamf
