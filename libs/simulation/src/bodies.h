// SPDX-License-Identifier: BSD-3-Clause
// The bodies by class; body.h says what holds for all of them. Radius and height are set there.
#pragma once

#include "vdamf/simulation/body.h"

namespace vdamf
{
Body carBody(ObjectClass style, const BodySize& size);  ///< Car, Hatchback, Suv
Body vanBody(const BodySize& size);

Body truckBody(const BodySize& size);
Body trailerBody(const BodySize& size);
Body busBody(const BodySize& size);
Body tramBody(const BodySize& size);

Body motorcycleBody(const BodySize& size);
Body bicycleBody(const BodySize& size);
Body pedestrianBody(const BodySize& size);

Body bushBody(const BodySize& size);
Body treeBody(const BodySize& size);
Body poleBody(const BodySize& size);
Body guardRailBody(const BodySize& size);
Body signBody(const BodySize& size);

}  // namespace vdamf
