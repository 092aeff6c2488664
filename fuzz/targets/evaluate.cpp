// SPDX-License-Identifier: BSD-3-Clause
// Truth and tracks scored: rows of `truth.csv` up to a line `---`, those of `tracks.csv` behind it,
// both without the line of names.
#include "memory_file.h"
#include "require.h"
#include "vdamf/evaluation/evaluation_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    constexpr std::string_view kBetween = "---\n";
    const std::string_view text = fuzz::textOf(data, size);
    const std::size_t between = text.find(kBetween);
    if (between == std::string_view::npos) return 0;
    const fuzz::MemoryFile truth(truthHeader().append(text.substr(0, between)));
    const fuzz::MemoryFile tracks(tracksHeader().append(text.substr(between + kBetween.size())));
    fuzz::mayRefuse(
        [&]
        {
            const auto truthRows = readTruth(truth.path());
            const auto trackRows = readTracks(tracks.path());
            const Evaluation evaluation = evaluate(truthRows, trackRows);
            const double mota = evaluation.clearMot.mota;
            fuzz::require(!(mota > 1.0), "MOTA is at most 1");
            fuzz::require(!toJson(evaluation).empty(), "an evaluation has a text");
        });
    return 0;
}
