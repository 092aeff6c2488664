// SPDX-License-Identifier: BSD-3-Clause
// A scenario from its first to its last frame into files.
#include "simulation_run.h"

#include <optional>
#include <stdexcept>

#include "simulated_rawlog.h"

namespace vdamf
{
namespace
{
/// Writes poses up to a scene time, in their order with the scans.
class PoseWriter
{
public:
    PoseWriter(const Scenario& scenario, SimulatedRawlog& recording)
        : recording_(recording), ins_(scenario)
    {
    }

    void writeUntil(double sceneTime)
    {
        constexpr double kRounding = 1e-6;  // times of scans are UNIX times
        while (ins_.nextTime() <= sceneTime + kRounding)
        {
            const InsSample sample = ins_.next();
            if (sample.isLost) continue;
            recording_.add(sample);
            ++written_;
        }
    }

    std::size_t written() const { return written_; }

private:
    SimulatedRawlog& recording_;
    InsSimulator ins_;
    std::size_t written_ = 0;
};

std::size_t countReturns(const SimulatedScan& scan)
{
    std::size_t count = 0;
    for (const LadarFiring& firing : scan.firings)
    {
        for (const LadarReturn& one : firing.returns) count += one.range > 0.0 ? 1 : 0;
    }
    return count;
}
}  // namespace

SimulationTotals runSimulation(const Scenario& scenario, const SimulationOutputs& outputs,
                               const std::function<bool(int, int)>& goOn)
{
    RawlogWriter::Options options;
    options.gzLevel = outputs.gzLevel;
    options.existing = outputs.existing;
    SimulatedRawlog recording(scenario, outputs.rawlog, options);
    std::optional<OutputFile> truth;
    if (!outputs.truth.empty())
    {
        truth.emplace(outputs.truth, outputs.existing, OutputFile::Unfinished::Discard);
        truth->write(truthHeader());
    }
    PoseWriter poses(scenario, recording);
    SimulationTotals totals;
    for (int i = 0; i < scenario.frames(); ++i)
    {
        const SimulatedFrame frame = simulateFrame(scenario, i);
        for (const SimulatedScan& scan : frame.scans)
        {
            poses.writeUntil(scan.time - scenario.run.startTime);
            recording.add(scan);
            totals.returns += countReturns(scan);
        }
        totals.scans += frame.scans.size();
        for (const TruthRow& row : frame.truth)
        {
            if (truth) truth->write(toCsv(row));
        }
        if (!goOn(i + 1, scenario.frames()))
        {
            throw std::runtime_error("interrupted; no output was kept");
        }
    }
    // One pose at or behind the end, so that the last scan is between two poses.
    poses.writeUntil(scenario.run.duration + 1.0 / scenario.run.insRate);
    totals.poses = poses.written();
    recording.commit();
    if (truth) truth->commit();
    return totals;
}

}  // namespace vdamf
