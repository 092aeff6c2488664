// SPDX-License-Identifier: BSD-3-Clause
// Options of the vehicle discriminator.
#pragma once

#include <memory>
#include <string>

#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
struct DiscriminatorOptions
{
    std::string model;
    double minProbability = 0.5;
    /// What `model` names, read by whoever reads files. Nothing: the built-in one.
    std::shared_ptr<const DiscriminatorModel> loaded;
    bool keepFeatures = false;  ///< TrackReport::features are filled: for training

    bool isOff() const { return model == "none"; }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.model, "model",
              "model file of vdamf-train classifier; empty: the built-in one; none: off");
        field(self.minProbability, "min_probability", 0.0, 1.0,
              "probability from which a track is called a vehicle");
    }
};

}  // namespace vdamf
