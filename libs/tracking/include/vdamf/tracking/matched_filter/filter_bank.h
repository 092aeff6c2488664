// SPDX-License-Identifier: BSD-3-Clause
// Learned filters: one for all vehicles, or one for each type of vehicle (the paper's future work).
#pragma once

#include <string>
#include <vector>

#include "vdamf/tracking/matched_filter/filter_parameters.h"
#include "vdamf/tracking/types/vehicle_type.h"

namespace vdamf
{
/// Sizes that are usual of a type: means and standard deviations, m.
struct TypeSizes
{
    double share = 1.0;  ///< of all vehicles
    double length = 4.5;
    double lengthSigma = 1.0;
    double width = 1.8;
    double widthSigma = 0.3;
    double height = 1.6;
    double heightSigma = 0.4;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.share, "share", 1e-4, 1.0, "of all vehicles");
        field(self.length, "size_length_m", 0.5, 40.0, "mean of the labelled vehicles");
        field(self.lengthSigma, "size_length_sigma_m", 0.02, 20.0, "and standard deviation");
        field(self.width, "size_width_m", 0.2, 5.0, "mean");
        field(self.widthSigma, "size_width_sigma_m", 0.02, 3.0, "and standard deviation");
        field(self.height, "size_height_m", 0.5, 6.0, "mean");
        field(self.heightSigma, "size_height_sigma_m", 0.02, 3.0, "and standard deviation");
    }
};

struct TypedFilter
{
    VehicleType type = VehicleType::Any;
    TypeSizes sizes;
    FilterParameters parameters;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        TypeSizes::visit(self.sizes, field);
        FilterParameters::visit(self.parameters, field);
    }
};

/// How filters were learned: lines of text.
struct FilterRecord
{
    std::string program;
    std::string data;
    std::string options;
    std::string heldOut;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.program, "program", "that learned them");
        field(self.data, "data", "labelled clusters");
        field(self.options, "options", "of the training");
        field(self.heldOut, "held_out", "on tracks that were not trained on");
    }
};

/// At least one filter, each of another type.
struct FilterBank
{
    FilterRecord record;
    std::vector<TypedFilter> filters;
};

/// That for any type where there is one, else the first.
const TypedFilter& commonFilter(const FilterBank& bank);

}  // namespace vdamf
