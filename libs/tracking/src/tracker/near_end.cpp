// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/near_end.h"

#include "types/box_changes.h"

namespace vdamf
{
Sighting withNearEndOfRow(Sighting sighting)
{
    constexpr double kBeyond = 0.2;  // m
    constexpr double kSigma = 0.15;  // m: corners are round
    Measurement& m = sighting.measurement;
    if (!m.facesSeen.seesSide()) return sighting;
    FaceRow& row = sighting.side;
    const int end = toBoxFrame(m.box, sighting.sensor).x() > 0.0 ? 1 : 0;
    const double near = signOfEnd(end);
    const double beyond = near * row.middle + 0.5 * row.metres - 0.5 * m.box.length;
    if (beyond < kBeyond) return sighting;
    const Vector5d change = byFace(rotation(m.box.heading), 0, end);
    m.box.x += near * beyond * change(0);
    m.box.y += near * beyond * change(1);
    m.box.length += beyond;
    row.middle -= 0.5 * near * beyond;
    m.facesSeen.remove(kFaceAt[0][end]);
    m.covariance += kSigma * kSigma * change * change.transpose();
    return sighting;
}

}  // namespace vdamf
