// SPDX-License-Identifier: BSD-3-Clause
#include "pictures.h"

#include <algorithm>

#include "vdamf/report/discriminator_plots.h"

namespace vdamf
{
namespace
{
/// Mean features of the grid's cells.
std::vector<double> meanCells(const std::vector<TrackSamples>& tracks, ObjectLabel label,
                              std::size_t cells)
{
    std::vector<double> mean(cells, 0.0);
    double samples = 0.0;
    for (const TrackSamples& track : tracks)
        for (const ObjectSample& sample : track.frames)
        {
            if (sample.label != label) continue;
            samples += 1.0;
            for (const SparseFeature& f : sample.features)
                if (f.index < cells) mean[f.index] += static_cast<double>(f.value);
        }
    for (double& cell : mean) cell /= std::max(1.0, samples);
    return mean;
}

std::vector<NamedRoc> curvesOf(const QualityReport& quality)
{
    std::vector<NamedRoc> curves;
    const auto add = [&](const char* name, const Quality& q)
    {
        if (q.roc) curves.push_back({name, *q.roc});
    };
    add("single frames", quality.frames);
    add("50 hits or more", quality.clearFrames);
    add("tracks", quality.tracks);
    return curves;
}
}  // namespace

const std::vector<std::string>& classifierPictureNames()
{
    static const std::vector<std::string> kNames = {"weights", "vehicles", "clutter",
                                                    "roc",     "det",      "reliability"};
    return kNames;
}

std::vector<Picture> classifierPictures(const DiscriminatorModel& model,
                                        const QualityReport& quality,
                                        const std::vector<TrackSamples>& tracks)
{
    const std::vector<NamedRoc> curves = curvesOf(quality);
    const auto cells = [&](ObjectLabel label, const char* title)
    { return cellsSvg(model.grid, meanCells(tracks, label, model.grid.cells()), title); };
    const Chart reliability = reliabilityChart(
        {{"single frames", quality.frames.reliability}, {"tracks", quality.tracks.reliability}});
    return {{"weights", weightsSvg(model)},
            {"vehicles", cells(ObjectLabel::Vehicle, "Hits on vehicles in the canonical frame")},
            {"clutter", cells(ObjectLabel::Clutter, "Hits on clutter in the canonical frame")},
            {"roc", chartsSvg({rocChart(curves)})},
            {"det", chartsSvg({detChart(curves)})},
            {"reliability", chartsSvg({reliability})}};
}

}  // namespace vdamf
