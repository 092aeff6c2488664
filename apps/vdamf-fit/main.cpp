// SPDX-License-Identifier: BSD-3-Clause
// vdamf-fit: the measurement alone, for any clusters of points.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "fit_table.h"
#include "program.h"
#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/configuration.h"

namespace
{
struct Cli
{
    std::filesystem::path input;
    std::filesystem::path output;
    std::filesystem::path config;
    std::vector<std::string> set;
    bool overwrite = false;
    bool quiet = false;
};

void declare(CLI::App& app, Cli& cli)
{
    app.add_option("-i,--input", cli.input, "clusters to fit (CSV)")->required();
    app.add_option("-o,--output", cli.output, "fits to write (CSV)")->required();
    app.add_option("-c,--config", cli.config,
                   "configuration (ini), of which [measurement] counts; default: built-in values");
    app.add_option("--set", cli.set, "section.key=value over the configuration (repeatable)")
        ->allow_extra_args(false);
    app.add_flag("--overwrite", cli.overwrite, "replace an existing output");
    app.add_flag("-q,--quiet", cli.quiet, "no summary");
}

vdamf::MeasureOptions prepared(const Cli& cli)
{
    const vdamf::Configuration configuration = vdamf::loadConfiguration(cli.config, cli.set);
    std::vector<vdamf::NamedInput> inputs = filesNamedBy(configuration);
    inputs.push_back({cli.input, "the input"});
    inputs.push_back({cli.config, "the configuration"});
    vdamf::checkOutputPaths({cli.output}, inputs);
    return configuration.tracker.measurement;
}

struct Tally
{
    std::size_t clusters = 0;
    std::size_t notConverged = 0;
    std::size_t withoutFit = 0;
    double fitSeconds = 0.0;
};

Tally fitAll(const Cli& cli, const vdamf::MeasureOptions& options)
{
    using Clock = std::chrono::steady_clock;
    vdamf::ClusterTable table(cli.input);
    vdamf::OutputFile file(cli.output,
                           cli.overwrite ? vdamf::OutputFile::Existing::Overwrite
                                         : vdamf::OutputFile::Existing::Refuse,
                           vdamf::OutputFile::Unfinished::Discard);
    constexpr std::size_t kPiece = 1 << 16;  // bytes written at once
    std::string text = vdamf::fitsHeader();
    Tally tally;
    while (const std::optional<vdamf::TableCluster> cluster = table.next())
    {
        if (vdamf::isInterrupted()) throw std::runtime_error("interrupted; no output was kept");
        const Clock::time_point begin = Clock::now();
        const vdamf::ClusterFit fit = vdamf::fitCluster(*cluster, options);
        tally.fitSeconds += std::chrono::duration<double>(Clock::now() - begin).count();
        ++tally.clusters;
        if (!fit.measurement) ++tally.withoutFit;
        if (fit.measurement && !fit.converged) ++tally.notConverged;
        text += vdamf::toCsv(*cluster, fit);
        if (text.size() < kPiece) continue;
        file.write(text);
        text.clear();
    }
    file.write(text);
    file.commit();
    return tally;
}

void summarise(const Cli& cli, const Tally& tally)
{
    std::printf("%s\n", cli.output.string().c_str());
    std::printf("  clusters       %zu\n", tally.clusters);
    std::printf("  without a fit  %zu\n", tally.withoutFit);
    std::printf("  not converged  %zu\n", tally.notConverged);
    std::printf("  time of a fit  %.1f us\n",
                1e6 * tally.fitSeconds / static_cast<double>(tally.clusters));
}

int run(const Cli& cli, const vdamf::MeasureOptions& options)
{
    vdamf::catchSignals();
    const Tally tally = fitAll(cli, options);
    if (!cli.quiet && !vdamf::isStandardOutput(cli.output)) summarise(cli, tally);
    return vdamf::kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    Cli cli;
    vdamf::MeasureOptions options;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-fit", "Fits the matched filter to clusters of points: pose, size and covariance.",
         "Example:\n  vdamf-fit -i clusters.csv -o fits.csv",
         [&](CLI::App& app) { declare(app, cli); }, [&] { options = prepared(cli); },
         [&] { return run(cli, options); }});
}
