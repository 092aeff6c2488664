// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/run_report.h"

#include <stdexcept>

#include "base64.h"
#include "hit_encoding.h"
#include "hit_selection.h"
#include "page.h"
#include "run_recording.h"
#include "truth_json.h"
#include "vdamf/files/gz_member.h"
#include "vdamf/tracking/matched_filter/filter_shape.h"

namespace vdamf
{
namespace
{
constexpr int kGzLevel = 6;

std::string packed(std::string_view bytes)
{
    return base64(gzMember(bytes, kGzLevel));
}

std::string dataElement(const std::string& id, const std::string& content)
{
    return "<script type=\"text/plain\" id=\"" + id + "\">" + content + "</script>\n";
}

/// As it is in UTF-8: what is none, as file names can have it, is U+FFFD.
std::string utf8(const std::string& text)
{
    constexpr auto kReplace = Json::error_handler_t::replace;
    return Json::parse(Json(text).dump(-1, ' ', false, kReplace)).get<std::string>();
}

Json filterJson()
{
    const FilterShape shape = FilterShape::paper();
    return {{"endMargin", shape.endMargin},
            {"sideMargin", shape.sideMargin},
            {"endStrip", shape.endStrip},
            {"sideStrip", shape.sideStrip},
            {"surroundWeight", shape.surroundWeight},
            {"interiorWeight", shape.interiorWeight}};
}

Json factsJson(const RunFacts& facts)
{
    Json rows = Json::array();
    for (const auto& [name, value] : facts.rows) rows.push_back({name, value});
    Json stages = Json::array();
    for (const auto& [name, millis] : facts.stageMillis)
        stages.push_back({name, rounded(millis, 3)});
    return {{"title", facts.title},
            {"version", facts.version},
            {"configuration", facts.configuration},
            {"rows", rows},
            {"stages", stages}};
}
}  // namespace

struct RunReport::Impl
{
    HitSelectionOptions selection;
    std::vector<RecordedFrame> frames;

    std::string html(const RunFacts& facts, const ReportTruth* truth) const
    {
        if (frames.empty()) throw std::runtime_error("a report needs at least one frame");
        const Json run = {{"facts", factsJson(facts)},
                          {"filter", filterJson()},
                          {"frames", framesJson(frames)},
                          {"tracks", tracksJson(frames)},
                          {"truth", truth != nullptr ? truthJson(frames, *truth) : Json(nullptr)}};
        // Texts that are no UTF-8, as file names can be, must not keep the report from being made.
        std::string data =
            dataElement("run", packed(run.dump(-1, ' ', false, Json::error_handler_t::replace)));
        for (std::size_t f = 0; f < frames.size(); ++f)
            data += dataElement("hits" + std::to_string(f), frames[f].hits);
        return pageWith(utf8(facts.title), data);
    }
};

RunReport::RunReport(const RunReportOptions& options) : impl_(std::make_unique<Impl>())
{
    impl_->selection.ground = options.ground;
    impl_->selection.clustering = options.clustering;
    impl_->selection.hitsPerFrame = options.hitsPerFrame;
}
RunReport::~RunReport() = default;
RunReport::RunReport(RunReport&&) noexcept = default;
RunReport& RunReport::operator=(RunReport&&) noexcept = default;

void RunReport::add(const LadarFrame& frame, const FrameResult& result)
{
    const ShownHits hits = selectHits(frame, result, impl_->selection);
    impl_->frames.push_back({result.time, frame.origin, frame.sensor, frame.points.size(),
                             hits.aboveGround, hits.clusterCount, packed(encoded(hits)),
                             result.tracks});
}

std::size_t RunReport::frames() const
{
    return impl_->frames.size();
}

std::string RunReport::html(const RunFacts& facts) const
{
    return impl_->html(facts, nullptr);
}

std::string RunReport::html(const RunFacts& facts, const ReportTruth& truth) const
{
    return impl_->html(facts, &truth);
}

}  // namespace vdamf
