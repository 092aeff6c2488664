// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/tracker/tracker.h"

#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
std::vector<std::string> TrackerOptions::problems() const
{
    std::vector<std::string> all;
    const auto add = [&](const char* section, const std::vector<std::string>& problems)
    {
        for (const std::string& p : problems) all.push_back("[" + std::string(section) + "] " + p);
    };
    add("ground", problemsOf(ground));
    add("clustering", problemsOf(clustering));
    add("association", problemsOf(association));
    add("measurement", problemsOf(measurement));
    add("visibility", problemsOf(visibility));
    add("motion", problemsOf(motion));
    add("alignment", problemsOf(alignment));
    add("lifecycle", problemsOf(lifecycle));
    add("tracker", problemsOf(execution));
    add("discriminator", problemsOf(discriminator));
    const DiscriminatorModel* const model = discriminator.loaded.get();
    if (model != nullptr && model->weights.size() != featureCount(model->grid))
        add("discriminator",
            {"the loaded model has " + std::to_string(model->weights.size()) + " weights for " +
             std::to_string(featureCount(model->grid)) + " features"});
    return all;
}

const char* toString(Stage stage)
{
    switch (stage)
    {
        case Stage::Ground:
            return "ground removal";
        case Stage::Clustering:
            return "clustering";
        case Stage::Prediction:
            return "prediction";
        case Stage::Association:
            return "association";
        case Stage::Measurement:
            return "matched filter";
        case Stage::Update:
            return "update";
        case Stage::NewTracks:
            return "new tracks";
        case Stage::Discrimination:
            return "discrimination";
    }
    return "";
}

}  // namespace vdamf
