// SPDX-License-Identifier: BSD-3-Clause
// Figures 8 to 10 of the paper from simulated recordings with truth.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <stdexcept>

#include "figures/scene.h"
#include "figures/view.h"
#include "program.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
namespace
{
struct Job
{
    std::filesystem::path rawlog;
    std::filesystem::path truth;
    std::string target;
    std::filesystem::path folder;
    bool isCircle = false;
};

struct Seen
{
    LadarFrame frame;
    FrameResult result;
};

std::vector<Seen> framesOf(const Job& job)
{
    TrackRawlogJob tracking;
    tracking.input = job.rawlog;
    const std::atomic<bool> stop{false};
    std::vector<Seen> all;
    trackRawlog(tracking, stop,
                [&](const LadarFrame& frame, const FrameResult& result, double) {
                    all.push_back({frame, result});
                });
    if (all.empty()) throw std::runtime_error(job.rawlog.string() + " holds no frames");
    return all;
}

std::optional<TruthRow> objectAt(const std::vector<TruthRow>& truth, const std::string& id,
                                 double time)
{
    for (const TruthRow& row : truth)
        if (row.objectId == id && std::abs(row.time - time) < 1e-3) return row;
    return std::nullopt;
}

void write(const std::filesystem::path& path, const std::string& svg)
{
    writeTextFile(path, svg);
    std::printf("%s\n", path.c_str());
}

/// Views of the target in all frames that it is in.
std::vector<FigureView> targetViews(const Job& job, const std::vector<TruthRow>& truth,
                                    const std::vector<Seen>& frames)
{
    std::vector<FigureView> views;
    for (const Seen& seen : frames)
        if (const auto object = objectAt(truth, job.target, seen.frame.time))
            views.push_back(
                viewOf(seen.frame, *object,
                       toFixedText(seen.frame.time - frames.front().frame.time, 1) + " s"));
    if (views.empty()) throw std::runtime_error("the truth has no object " + job.target);
    return views;
}

enum class Choice
{
    Middle,
    Longest  ///< the one whose fit is longest: it shows more than an end of the target
};

/// One of each `count`-th part of the views.
std::vector<FigureView> oneOfEachPart(const std::vector<FigureView>& views, std::size_t count,
                                      Choice choice)
{
    std::vector<FigureView> chosen;
    for (std::size_t k = 0; k < count; ++k)
    {
        const auto at = [&](std::size_t part)
        { return views.begin() + static_cast<std::ptrdiff_t>(part * views.size() / (2 * count)); };
        const auto first = at(2 * k);
        const auto end = at(2 * k + 2);
        if (first == end) continue;
        const auto longest =
            std::max_element(first, end,
                             [](const FigureView& a, const FigureView& b)
                             { return a.measured.box.length < b.measured.box.length; });
        chosen.push_back(choice == Choice::Longest ? *longest : *at(2 * k + 1));
    }
    return chosen;
}

/// The track with most hits that is called clutter, as it is fitted.
std::optional<FigureView> clutterView(const Seen& seen, double groundZ)
{
    const TrackReport* most = nullptr;
    for (const TrackReport& track : seen.result.tracks)
        if (!track.isVehicle.value_or(true) && track.box.length > 1.5 &&
            (most == nullptr || track.points > most->points))
            most = &track;
    if (most == nullptr) return std::nullopt;
    return viewOf(seen.frame, most->box, groundZ, "clutter");
}

void drawWoods(const Job& job, const std::vector<TruthRow>& truth)
{
    const std::vector<Seen> frames = framesOf(job);
    std::vector<FigureView> views =
        oneOfEachPart(targetViews(job, truth, frames), 3, Choice::Longest);
    const Seen& middle = frames[frames.size() / 2];
    const double groundZ = objectAt(truth, job.target, middle.frame.time).value().z;
    write(job.folder / "fig09_scene.svg", sceneSvg(middle.frame, middle.result));
    FigureView oblique = views.back();
    oblique.caption.clear();
    write(job.folder / "fig10e_hits.svg", obliqueSvg(oblique));
    if (const auto clutter = clutterView(middle, groundZ)) views.push_back(*clutter);
    write(job.folder / "fig10_fits.svg", viewsSvg(views, 4));
}

void drawCircle(const Job& job, const std::vector<TruthRow>& truth)
{
    const std::vector<FigureView> views = targetViews(job, truth, framesOf(job));
    write(job.folder / "fig08_circle.svg", viewsSvg(oneOfEachPart(views, 12, Choice::Middle), 4));
}

int draw(const Job& job)
{
    const std::vector<TruthRow> truth = readTruth(job.truth);
    job.isCircle ? drawCircle(job, truth) : drawWoods(job, truth);
    return kDone;
}

void declare(CLI::App& app, Job& job)
{
    app.add_option("-i,--input", job.rawlog, "rawlog")->required();
    app.add_option("--truth", job.truth, "its truth.csv")->required();
    app.add_option("--target", job.target, "object of the truth to look at")->required();
    app.add_option("-o,--output", job.folder, "folder of the pictures")->required();
    app.add_flag("--circle", job.isCircle, "Fig. 8; else Fig. 9 and 10");
}
}  // namespace
}  // namespace vdamf

int main(int argc, char** argv)
{
    vdamf::Job job;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf_paper_figures",
         "Draws figures 8 to 10 of the paper; run by scripts/paper-figures.sh.", "",
         [&](CLI::App& app) { vdamf::declare(app, job); }, nullptr,
         [&] { return vdamf::draw(job); }});
}
