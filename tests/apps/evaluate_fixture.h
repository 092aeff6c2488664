// SPDX-License-Identifier: BSD-3-Clause
// Tables of two cars, and vdamf-evaluate run on them.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "apps/command_line.h"
#include "evaluation/example_pairs.h"
#include "files/temporary_folder.h"

namespace vdamf
{
class EvaluateAppTest : public TemporaryFolder
{
protected:
    using Json = nlohmann::json;
    using Change = std::function<std::vector<TrackRow>(TrackRow, int frame)>;

    /// Two cars in lanes 20 m apart, 20 frames, 5 m/s along x; a table of tracks on them, changed.
    void writeTables(const Change& change) const
    {
        std::string truthTable = truthHeader();
        std::string trackTable = tracksHeader();
        for (int frame = 0; frame < 20; ++frame)
        {
            for (int car = 1; car <= 2; ++car)
            {
                TruthRow truth = exampleCar(100.0 + 0.1 * frame, "car" + std::to_string(car));
                truth.box = {0.5 * frame, 20.0 * car, 0.0, 4.0, 2.0};
                truth.sensor = PlanePose{-10.0, 20.0, 0.0};
                truthTable += toCsv(truth);
                const auto id = static_cast<std::uint64_t>(car);
                for (const TrackRow& row : change(trackOn(truth, id), frame))
                    trackTable += toCsv(FrameResult{row.time, {row.report}, 0, 0, 0, {}});
            }
        }
        make("truth.csv", truthTable);
        make("tracks.csv", trackTable);
    }

    Outcome evaluate(const std::string& more = "") const
    {
        return runApp("vdamf-evaluate", "--tracks '" + at("tracks.csv").string() + "' --truth '" +
                                            at("truth.csv").string() + "' " + more);
    }

    Json metrics(const std::string& more = "") const
    {
        const Outcome run = evaluate("--overwrite --json '" + at("m.json").string() + "' " + more);
        EXPECT_EQ(run.exitCode, 0) << run.output;
        return Json::parse(contentOf("m.json"));
    }
};

inline std::vector<TrackRow> unchanged(TrackRow row, int /*frame*/)
{
    return {std::move(row)};
}

}  // namespace vdamf
