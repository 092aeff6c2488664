// SPDX-License-Identifier: BSD-3-Clause
// The pictures of a training: Figs. 10 and 11 of the paper from other data.
#pragma once

#include <string>
#include <vector>

#include "quality.h"
#include "vdamf/learning/sample.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
struct Picture
{
    std::string name;  ///< of its file, without extension
    std::string svg;
};

/// weights, vehicles and clutter (mean cells), roc, det, reliability.
const std::vector<std::string>& classifierPictureNames();

std::vector<Picture> classifierPictures(const DiscriminatorModel& model,
                                        const QualityReport& quality,
                                        const std::vector<TrackSamples>& tracks);

}  // namespace vdamf
