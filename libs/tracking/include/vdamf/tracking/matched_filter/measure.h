// SPDX-License-Identifier: BSD-3-Clause
// Section 4 as one call: start, fit, covariance, faces seen.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "vdamf/tracking/matched_filter/filter_bank.h"
#include "vdamf/tracking/matched_filter/fit.h"
#include "vdamf/tracking/types/measurement.h"

namespace vdamf
{
enum class FilterKind
{
    Paper,         ///< Table 1
    PaperInset,    ///< Table 1, its faces moved inwards by its median bias, by face and aspect
    CoarseToFine,  ///< Table 1, then the same filter with narrower strips and sigma, twice
    FaceLines      ///< Table 1, then robust lines through the hits of the faces seen
};

template <>
struct EnumNames<FilterKind>
{
    static std::vector<std::pair<FilterKind, const char*>> names()
    {
        return {{FilterKind::Paper, "paper"},
                {FilterKind::PaperInset, "paper_inset"},
                {FilterKind::CoarseToFine, "coarse_to_fine"},
                {FilterKind::FaceLines, "face_lines"}};
    }
};

struct MeasureOptions
{
    FilterKind filter = FilterKind::FaceLines;
    double sigma = 0.2;                       ///< m
    double mergeCell = 0.1;                   ///< m
    double hitSigma = 0.12;                   ///< m
    double rangeNoise = 0.02;                 ///< m
    double bodyDepth = 0.06;                  ///< m
    double hiddenFaceSigma = 1.0;             ///< m
    double sizePriorWeight = 0.02;            ///< 1/m^3
    double minEndAngle = 10.0 * kPi / 180.0;  ///< rad
    double minSideAngle = 5.0 * kPi / 180.0;  ///< rad
    int minFaceHits = 5;
    bool reachOverHits = true;
    std::string filterFile;
    /// What is learned. sigma and hitSigma stand above, see withFilter().
    FilterParameters parameters;
    /// What filterFile names, read by whoever reads files.
    std::shared_ptr<const FilterBank> bank;
    FitOptions fit;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.filter, "filter",
              "filter: Table 1 of the paper, less its median bias, twice narrowed, or on to the "
              "faces");
        field(self.sigma, "sigma_m", 0.02, 1.0,
              "standard deviation of the Gaussian around each hit (Eq. 2)");
        field(
            self.mergeCell, "merge_cell_m", 0.0, 0.5,
            "hits that share a cell of this size count as one Gaussian with their weight; 0: off");
        field(self.hitSigma, "hit_sigma_m", 0.001, 1.0,
              "sigma_p of Eq. 14: effective scatter of one hit about the surface");
        field(self.rangeNoise, "range_noise_m", 0.0, 1.0,
              "face_lines: standard deviation of the sensor's ranges; 0: by the hits of each fit");
        field(self.bodyDepth, "body_depth_m", 0.0, 1.0,
              "face_lines: how far a car's sill and nose lie behind its bumper; 0: upright walls");
        field(self.hiddenFaceSigma, "hidden_face_sigma_m", 0.01, 10.0,
              "face_lines: error of the place of a face that nothing shows");
        field(
            self.sizePriorWeight, "size_prior_weight", 0.0, 10.0,
            "pull of a track's known size on the fit, response per hit / m^2; 0: as in the paper");
        field(self.minEndAngle, "min_end_angle_deg", 0.0, 45.0,
              "grazing angle from which front or rear, whose corners are round, counts as seen");
        field(self.minSideAngle, "min_side_angle_deg", 0.0, 45.0,
              "grazing angle from which a side, a long row of hits, counts as seen");
        field(self.minFaceHits, "min_face_hits", 1, 100, "hits that a face needs to count as seen");
        field(self.reachOverHits, "reach_over_hits",
              "far ends of the box at the end of the rows of hits along its seen faces");
        field(self.filterFile, "filter_file",
              "learned filters of vdamf-train filter, with a sigma_m and a hit_sigma_m of their "
              "own; empty: set by hand");
        FitOptions::visit(self.fit, field);
    }
};

/// With a learned filter in place of the one that the options have.
MeasureOptions withFilter(const MeasureOptions& options, const FilterParameters& parameters);

/// Faces of the box towards the sensor with enough hits in the filter's strip along them; a hit in
/// the corner of two strips counts for neither.
FaceSet facesSeen(const Hits& hits, const OrientedBox& box, const Eigen::Vector2d& sensor,
                  const MeasureOptions& options);

/// How far a measurement goes for a better result.
struct SearchEffort
{
    /// Response per hit, 1/m: where the start leads to no more, the filter begins where the hits
    /// are as well.
    double enoughMatch = 0.0;
    /// The first result is taken, however few hits lie on its lines, and where no face is seen it
    /// is as vague as that alone makes it: for what is hardly a vehicle.
    bool isFirstTaken = false;
};

/// Measures a target from a start, for example a track's predicted pose and size. `known` size, if
/// given, is held to with sizePriorWeight. Coordinates: those of the hits.
Measurement measureTarget(const Hits& hits, const Eigen::Vector2d& sensor, const OrientedBox& start,
                          const MeasureOptions& options,
                          const std::optional<Eigen::Vector2d>& knownLengthWidth = std::nullopt,
                          const SearchEffort& effort = {});

/// Width (m) above which a face cannot be a vehicle's end, by the vehicle's height (m): what is low
/// is a car, trucks and buses are wider.
double widestEnd(double height);

/// Start for hits of which nothing is known (4.3: "the boundaries of each cluster provide a
/// starting state"): the rectangle around them whose edges they follow best, with the heading
/// along its longer side, unless it is a single row no longer than `widestEnd` (m), which is taken
/// for a vehicle's end. Of the two directions along the heading the one away from the sensor is
/// taken.
OrientedBox startBox(const Hits& hits, const Eigen::Vector2d& sensor, double widestEnd,
                     const FitOptions& options);

/// A box of the same heading and size moved so that its faces towards the sensor lie where the hits
/// begin: a start for a target whose predicted position is vague.
OrientedBox movedOntoHits(const OrientedBox& box, const Hits& hits, const Eigen::Vector2d& sensor);

}  // namespace vdamf
