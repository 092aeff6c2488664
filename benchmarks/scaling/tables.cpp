// SPDX-License-Identifier: BSD-3-Clause
#include "scaling/tables.h"

#include <cstdarg>
#include <cstdio>
#include <map>

#include "vdamf/report/plots.h"

namespace vdamf
{
namespace
{
constexpr double kMs = 1e3;

// As printf does it.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...)
{
    char buffer[256];
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    return buffer;
}

Curve reference(const char* name, std::initializer_list<Eigen::Vector2d> points)
{
    return {name, CurveStyle::Dashed, points};
}
}  // namespace

std::string stageTable(const std::vector<TimedRun>& runs)
{
    const auto row = [&](const char* title, const auto& value, const char* format = "%14.2f")
    {
        std::string line = text("%-24s", title);
        for (const TimedRun& run : runs)
        {
            char cell[32];
            std::snprintf(cell, sizeof cell, format, value(run));
            line += cell;
        }
        return line + "\n";
    };
    std::string table = text("%-24s", "ms a frame, median");
    for (const TimedRun& run : runs) table += text("%14s", run.scene.c_str());
    table += "\n";
    constexpr const char* kCount = "%14.0f";
    table += row(
        "threads", [](const TimedRun& r) { return double(r.threads); }, kCount);
    table += row(
        "points", [](const TimedRun& r) { return r.times.points; }, kCount);
    table += row(
        "clusters", [](const TimedRun& r) { return r.times.clusters; }, kCount);
    table += row(
        "tracks", [](const TimedRun& r) { return r.times.tracks; }, kCount);
    for (std::size_t k = 0; k < kStages; ++k)
        table += row(toString(static_cast<Stage>(k)),
                     [k](const TimedRun& r) { return kMs * r.times.stages[k].processor; });
    table +=
        row("all, of the processor", [](const TimedRun& r) { return kMs * r.times.all.processor; });
    table += row("all, on the clock", [](const TimedRun& r) { return kMs * r.times.all.wall; });
    return table;
}

std::string timesCsv(const std::vector<TimedRun>& runs)
{
    std::string csv = "scene,targets,threads,frames,points,clusters,tracks";
    const auto columns = [&](std::string name)
    {
        for (char& c : name)
            if (c == ' ') c = '_';
        csv += "," + name + "_processor_ms," + name + "_clock_ms";
    };
    for (std::size_t k = 0; k < kStages; ++k) columns(toString(static_cast<Stage>(k)));
    columns("all");
    csv += "\n";
    for (const TimedRun& run : runs)
    {
        const SequenceTimes& t = run.times;
        csv += text("%s,%d,%d,%zu,%.0f,%.0f,%.0f", run.scene.c_str(), run.targets, run.threads,
                    t.frames, t.points, t.clusters, t.tracks);
        for (const Duration& d : t.stages)
            csv += text(",%.4f,%.4f", kMs * d.processor, kMs * d.wall);
        csv += text(",%.4f,%.4f\n", kMs * t.all.processor, kMs * t.all.wall);
    }
    return csv;
}

std::string scalingSvg(const std::vector<TimedRun>& runs)
{
    Chart chart;
    chart.title = "Time a frame by the number of targets";
    chart.x = {"targets", AxisScale::Log10};
    chart.y = {"ms a frame", AxisScale::Log10};
    std::map<int, Curve> byThreads;
    for (const TimedRun& run : runs)
    {
        if (run.targets == 0) continue;
        Curve& curve = byThreads[run.threads];
        curve.name = run.threads == 1 ? "one thread" : text("%d threads", run.threads);
        curve.points.emplace_back(run.targets, kMs * run.times.all.wall);
    }
    for (const auto& [threads, curve] : byThreads) chart.curves.push_back(curve);
    if (!byThreads.empty())
    {
        const std::vector<Eigen::Vector2d>& one = byThreads.begin()->second.points;
        chart.curves.push_back(
            reference("10 frames a second", {{one.front().x(), 100.0}, {one.back().x(), 100.0}}));
    }
    chart.legendAtBottom = true;
    return chartsSvg({chart}, 1);
}

}  // namespace vdamf
