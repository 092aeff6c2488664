// SPDX-License-Identifier: BSD-3-Clause
#include "program.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <functional>
#include <new>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
std::atomic<bool> interrupted{false};

void onSignal(int /*signal*/)
{
    interrupted = true;
}

int saidWhy(const Program& program, const std::exception& error, int exitCode)
{
    const char* const wipeProgress = isTerminal() ? "\r\033[K" : "";
    std::fprintf(stderr, "%s%s: %s\n", wipeProgress, program.name.c_str(), reasonOf(error).c_str());
    return exitCode;
}

/// The exit code of the work, which has failed as well where what was printed is lost.
int worked(const Program& program, const std::function<int()>& work)
{
    try
    {
        const int exitCode = work();
        checkPrinted(stdout);
        return exitCode;
    }
    catch (const std::exception& error)
    {
        return saidWhy(program, error, kFailed);
    }
}

void declareCommon(CLI::App& app, const Program& program)
{
    app.set_version_flag("--version", program.name + " " + VDAMF_VERSION);
    app.footer(program.footer);
    app.failure_message(
        [name = program.name](const CLI::App*, const CLI::Error& error)
        { return name + ": " + error.what() + "\nRun with --help for more information.\n"; });
}

// CLI11 takes 010 for 8 and 0x10 for 16.
void takeDecimals(CLI::App& app)
{
    const auto decimal = [](std::string& text)
    {
        const auto value = parseInteger(text);
        if (!value) return "'" + text + "': expected a whole number";
        text = std::to_string(*value);
        return std::string();
    };
    for (CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    {
        const std::string type = option->get_type_name();
        const bool isWhole = type.rfind("INT", 0) == 0 || type.rfind("UINT", 0) == 0;
        if (isWhole) option->transform(CLI::Validator(decimal, ""));
    }
    for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        takeDecimals(*command);
}

// An empty value is one that was lost, as of a variable of a script that is not set.
[[noreturn]] void failEmpty(const std::string& option)
{
    throw CLI::ValidationError(option, "its value is empty; name one, or leave the option out");
}

// Of "--option=" the parser takes the next argument for the value.
void checkArguments(int argc, const char* const* argv)
{
    for (int i = 1; i < argc; ++i)
    {
        const std::string text = argv[i];
        const bool isOption = text.rfind("--", 0) == 0 && text.size() > 3;
        if (isOption && text.find('=') == text.size() - 1)
            failEmpty(text.substr(0, text.size() - 1));
    }
}

void checkValues(const CLI::App& app)
{
    for (const CLI::Option* option : app.get_options())
    {
        const std::vector<std::string>& values = option->results();
        if (std::find(values.begin(), values.end(), "") != values.end())
            failEmpty(option->get_name());
    }
    for (const CLI::App* command : app.get_subcommands()) checkValues(*command);
}
}  // namespace

int runProgram(int argc, const char* const* argv, const Program& program)
{
    CLI::App app(program.purpose, program.name);
    try
    {
        declareCommon(app, program);
        program.declare(app);
        takeDecimals(app);
        checkArguments(argc, argv);
        app.parse(argc, argv);
        checkValues(app);
        if (program.prepare) program.prepare();
    }
    catch (const CLI::ParseError& error)
    {
        std::ostringstream told;  // by --help or --version; std::cout would lose why it fails
        if (app.exit(error, told) != 0) return kBadUse;
        return worked(program,
                      [&]
                      {
                          std::fputs(told.str().c_str(), stdout);
                          return kDone;
                      });
    }
    catch (const std::exception& error)
    {
        return saidWhy(program, error, kBadUse);
    }
    return worked(program, program.work);
}

std::string reasonOf(const std::exception& error)
{
    return dynamic_cast<const std::bad_alloc*>(&error) ? "out of memory" : error.what();
}

const std::atomic<bool>& catchSignals()
{
    struct sigaction action = {};
    action.sa_handler = onSignal;
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
    // A closed terminal ends what nobody has started with nohup.
    struct sigaction before = {};
    sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
    return interrupted;
}

bool isInterrupted()
{
    return interrupted;
}

CLI::Validator within(double min, double max)
{
    const std::string range = toText(min) + " to " + toText(max);
    return {[=](std::string& text)
            {
                const auto value = parseNumber(text);
                const bool isInside = value && *value >= min && *value <= max;
                return isInside ? std::string() : "'" + text + "': expected " + range;
            },
            "FLOAT in [" + range + "]"};
}

void checkPrinted(std::FILE* stream)
{
    errno = 0;
    if (std::fflush(stream) == 0 && std::ferror(stream) == 0) return;
    throw std::runtime_error("cannot write to the standard output: " +
                             std::system_category().message(errno != 0 ? errno : EIO));
}

bool isTerminal()
{
    return isatty(STDERR_FILENO) != 0;
}

}  // namespace vdamf
