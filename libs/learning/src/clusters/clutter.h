// SPDX-License-Identifier: BSD-3-Clause
// What stands in a simulated cluster: the vehicle, and what disturbs the fit.
#pragma once

#include <vector>

#include "clusters/body_view.h"

namespace vdamf
{
/// ObjectClass::Box: walls so high that no roof is seen, shown up to the size's height.
StandingBody vehicle(ObjectClass body, const BodySize& size, const OrientedBox& box);

/// Two mirrors, 0.2 m beyond the sides, a third of the length behind the front.
std::vector<StandingBody> mirrors(const BodySize& size, const OrientedBox& box);

/// A bush of 1 to 2 m, 0.3 to 0.6 m beside a face drawn at random.
StandingBody bushBeside(const OrientedBox& box, RandomStream& random);

/// With hits, `share` of all, anywhere in the box grown by 1 m.
BodyView withClutter(const BodyView& view, const OrientedBox& box, double share,
                     RandomStream& random);

}  // namespace vdamf
