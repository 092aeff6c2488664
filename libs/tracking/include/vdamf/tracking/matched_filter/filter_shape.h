// SPDX-License-Identifier: BSD-3-Clause
// Table 1 of the paper: the regions of the view-dependent adaptive matched filter.
#pragma once

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
/// Dimensions and weights of the filter's four rectangles. Length l and width w of the target and
/// the sensor angle beta complete it: the visible end weighs |cos beta|, the visible side
/// |sin beta|, on top of the interior; of the two, the heavier one takes the corner they share.
struct FilterShape
{
    double endMargin = 0.75;        ///< surround beyond each end: (l + 1.5 m), m
    double sideMargin = 0.5;        ///< surround beyond each side: (w + 1.0 m), m
    double endStrip = 0.8;          ///< depth of the visible end's strip, m
    double sideStrip = 0.6;         ///< depth of the visible side's strip, m
    double surroundWeight = -0.25;  ///< of the surround's rectangle, and so of its outer ring
    double interiorWeight = 0.1;    ///< net of the surround below it: 0.1 + 0.25 - 0.25
    double sigma = 0.2;             ///< of the Gaussian around each hit, m (not in the paper)

    /// Table 1 to the letter. The paper does not give sigma; 0.2 m is our choice.
    static FilterShape paper() { return {}; }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.endMargin, "end_margin_m", 0.1, 2.0, "surround beyond each end");
        field(self.sideMargin, "side_margin_m", 0.1, 2.0, "surround beyond each side");
        field(self.endStrip, "end_strip_m", 0.05, 0.84, "depth of the visible end's strip");
        field(self.sideStrip, "side_strip_m", 0.05, 0.64, "depth of the visible side's strip");
        field(self.surroundWeight, "surround_weight", -1.0, 0.0, "weight around the target");
        field(self.interiorWeight, "interior_weight", -0.5, 0.5,
              "weight inside of it; edges in full view weigh 1");
        field(self.sigma, "sigma_m", 0.02, 1.0,
              "standard deviation of the Gaussian around each hit (Eq. 2)");
    }
};

}  // namespace vdamf
