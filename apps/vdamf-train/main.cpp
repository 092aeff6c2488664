// SPDX-License-Identifier: BSD-3-Clause
// vdamf-train: learns from recordings with truth.
#include <functional>

#include "classifier_command.h"
#include "filter_command.h"
#include "program.h"

namespace
{
struct CommandLine
{
    vdamf::ClassifierCommandLine classifier;
    vdamf::FilterCommandLine filter;
    std::function<void()> prepare;  // of the subcommand that was named
    std::function<void()> work;
};

void declare(CLI::App& app, CommandLine& line)
{
    app.require_subcommand(1);
    CLI::App* const classifier =
        app.add_subcommand("classifier", "trains the vehicle discriminator");
    declareClassifier(*classifier, line.classifier);
    classifier->final_callback(
        [&line]
        {
            line.prepare = [&line] { line.classifier.job = prepared(line.classifier); };
            line.work = [&line] { trainClassifier(line.classifier.job, vdamf::catchSignals()); };
        });
    CLI::App* const filter = app.add_subcommand("filter", "learns filters from labelled clusters");
    declareFilter(*filter, line.filter);
    filter->final_callback(
        [&line]
        {
            line.prepare = [&line] { line.filter.job = prepared(line.filter); };
            line.work = [&line] { trainFilter(line.filter.job, vdamf::catchSignals()); };
        });
}
}  // namespace

int main(int argc, char** argv)
{
    CommandLine line;
    const auto work = [&]
    {
        line.work();
        return vdamf::kDone;
    };
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-train", "Learns from recordings with truth.",
         "Examples:\n  vdamf-train classifier recordings.ini -o vehicle.txt --plots plots\n"
         "  vdamf-train filter sources.ini -o filters.txt",
         [&](CLI::App& app) { declare(app, line); }, [&] { line.prepare(); }, work});
}
