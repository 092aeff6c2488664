// SPDX-License-Identifier: BSD-3-Clause
// All of the measurement that is learned from labelled vehicles.
#pragma once

#include "vdamf/tracking/matched_filter/filter_shape.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
/// The median bias of the filter by itself (FilterKind::PaperInset), which is taken off its box.
struct InsetParameters
{
    double end = 0.32;        ///< of an end, up to an aspect of 45 degrees, m
    double grazingEnd = 0.1;  ///< and where it is seen at a grazing angle, m
    double side = 0.285;      ///< m
    double length = 0.05;     ///< by which it is too long, m
    double width = 0.15;      ///< and too wide, m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.end, "end_inset_m", -0.5, 0.8, "paper_inset: the visible end moves inwards");
        field(self.grazingEnd, "grazing_end_inset_m", -0.5, 0.8,
              "paper_inset: the same where it is seen at a grazing angle");
        field(self.side, "side_inset_m", -0.5, 0.8, "paper_inset: the visible side moves inwards");
        field(self.length, "length_excess_m", -1.0, 1.0, "paper_inset: too long by so much");
        field(self.width, "width_excess_m", -1.0, 1.0, "paper_inset: too wide by so much");
    }
};

/// Which hits are taken for those of a face (FilterKind::FaceLines).
struct LineParameters
{
    double reach = 0.7;       ///< m, of the first look
    double reachSigma = 0.2;  ///< m
    double gate = 0.35;       ///< m, of the second one
    double gateSigma = 0.12;  ///< m
    double corner = 0.25;     ///< m
    double fewInRow = 20.0;   ///< hits
    double fitExcess = 0.4;   ///< m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.reach, "reach_m", 0.2, 1.5, "hits so near to the filter's faces may be on them");
        field(self.reachSigma, "reach_sigma_m", 0.03, 0.5, "width of those lines at first");
        field(self.gate, "gate_m", 0.1, 1.0, "hits so near to the lines through those are on them");
        field(self.gateSigma, "gate_sigma_m", 0.02, 0.5, "width of those lines at first");
        field(self.corner, "corner_m", 0.0, 0.6, "round corners: hits of two faces are on neither");
        field(self.fewInRow, "few_in_row", 1.0, 200.0, "hits of a row that hides half its end");
        field(self.fitExcess, "fit_excess_m", 0.0, 1.5,
              "rows go on over gaps up to so much inside of the filter's far end");
    }
};

/// From the lines to the hull of the body. Lengths in units of body_depth_m where nothing else is
/// said.
struct HullParameters
{
    double front = 2.0;       ///< over the departure of the hits outside of the line
    double back = 1.6;        ///< likewise
    double side = 1.2;        ///< likewise
    double usual = 1.0;       ///< factor on the usual departures
    double usualHits = 15.0;  ///< that these count for
    double beyond = 1.0;      ///< factor on what lies beyond the heights that were seen
    double roundEnd = 2.0;    ///< of a far end, over the departure of the near faces
    double farEnd = 4.0;      ///< beyond rows of few hits
    double farSide = 1.3;     ///< likewise
    double farCorner = 2.2;   ///< of a car beyond the end of a row at a grazing angle
    double sideTurn = 0.015;  ///< rad/m, of a side over the tangent of the grazing angle

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.front, "front_to_hull", 0.0, 6.0, "from line to hull over the hits' departure");
        field(self.back, "back_to_hull", 0.0, 6.0, "the same of rears");
        field(self.side, "side_to_hull", 0.0, 6.0, "the same of sides");
        field(self.usual, "usual_departure", 0.0, 4.0, "factor on the departures of few hits");
        field(self.usualHits, "usual_hits", 0.0, 200.0, "hits that those count for");
        field(self.beyond, "beyond", 0.0, 4.0, "factor on what the heights seen leave out");
        field(self.roundEnd, "round_end", 0.0, 8.0, "from a row's end to the hull, likewise");
        field(self.farEnd, "far_end", 0.0, 12.0, "hidden length behind few hits, body depths");
        field(self.farSide, "far_side", 0.0, 12.0, "hidden width behind few hits, body depths");
        field(self.farCorner, "far_corner", 0.0, 12.0,
              "cars go on behind a row of hits seen at a grazing angle, body depths");
        field(self.sideTurn, "side_turn", 0.0, 0.1,
              "by which a side seems to turn away, over the tangent of its grazing angle, rad/m");
    }
};

/// What the covariance is made of, beside the scatter of the hits.
struct ErrorParameters
{
    double hull = 1.0;           ///< factor
    double taper = 0.05;         ///< over the departure of the hits inside of a side's line
    double endTaper = 0.12;      ///< likewise of an end's
    double least = 0.0025;       ///< m
    double turn = 0.4;           ///< over the departure outside
    double taperTurn = 0.07;     ///< and inside of the line
    double bodyTurn = 0.003;     ///< rad
    double turnDoubt = 0.02;     ///< rad
    double endDoubt = 0.12;      ///< m
    double sideDoubt = 0.08;     ///< m
    double hitSigma = 0.12;      ///< m
    double endRoughness = 0.05;  ///< m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.hull, "hull_error", 0.0, 5.0, "factor on the error from line to hull");
        field(self.taper, "taper_error", 0.0, 2.0, "of a side over its hits' departure inwards");
        field(self.endTaper, "end_taper_error", 0.0, 2.0, "the same of an end");
        field(self.least, "least_error_m", 0.0005, 0.2, "of any face");
        field(self.turn, "turn_error", 0.0, 5.0, "of the heading by the departure outwards");
        field(self.taperTurn, "taper_turn_error", 0.0, 2.0, "and by that inwards");
        field(self.bodyTurn, "body_turn_error_rad", 0.0, 0.1, "of any body's heading");
        field(self.turnDoubt, "turn_doubt_rad", 0.0, 0.5,
              "of the heading, over the square of the share of hits off the lines");
        field(self.endDoubt, "end_doubt_m", 0.0, 2.0, "the same of an end");
        field(self.sideDoubt, "side_doubt_m", 0.0, 2.0, "the same of a side");
        field(self.hitSigma, "hit_sigma_m", 0.001, 1.0,
              "sigma_p of Eq. 14: effective scatter of one hit about the surface");
        field(self.endRoughness, "end_roughness_m", 0.001, 0.5, "of the end of a row of hits");
    }
};

/// The defaults are set by hand: Table 1 and Monte Carlo on simulated vehicles.
struct FilterParameters
{
    FilterShape shape;
    InsetParameters insets;
    LineParameters lines;
    HullParameters hull;
    ErrorParameters errors;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        FilterShape::visit(self.shape, field);
        InsetParameters::visit(self.insets, field);
        LineParameters::visit(self.lines, field);
        HullParameters::visit(self.hull, field);
        ErrorParameters::visit(self.errors, field);
    }
};

}  // namespace vdamf
