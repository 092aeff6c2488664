// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "tracker/one_time.h"
#include "tracker/sighting.h"

namespace vdamf
{
/// Hits that were all seen at one time.
inline HitsAtOneTime seenAs(Cluster hits)
{
    HitsAtOneTime seen;
    seen.hits = projectHits(hits, 0.0);
    seen.each = std::move(hits);
    return seen;
}

}  // namespace vdamf
