// SPDX-License-Identifier: BSD-3-Clause
// The text form of a model: docs/discriminator.md.
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "vdamf/tracking/discrimination/features.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
namespace
{
constexpr const char* kFirstLine = "vdamf discriminator 3";
constexpr int kMostCells = 200;   // along one axis
constexpr double kLargest = 1e6;  // so that no score overflows

/// Shortest decimal text that reads back as exactly this number.
std::string numberText(double value)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

std::string line(const std::string& key, const std::vector<double>& numbers)
{
    std::string text = key;
    for (const double number : numbers) text += ' ' + numberText(number);
    return text + '\n';
}

/// Reads line by line; errors name file and line.
class ModelReader
{
public:
    ModelReader(const std::string& text, const std::string& name) : lines_(text), name_(name) {}

    /// The next line, without a carriage return at its end.
    std::string next(const std::string& expected)
    {
        ++line_;
        std::string text;
        if (!std::getline(lines_, text))
            fail("the model ends here, expected " + expected + ": is the file whole?");
        if (!text.empty() && text.back() == '\r') text.pop_back();
        return text;
    }

    /// A line of the key and `count` numbers.
    std::vector<double> numbers(const std::string& key, std::size_t count)
    {
        std::istringstream words(next("'" + key + "'"));
        std::string word;
        words >> word;
        if (word != key) fail("expected '" + key + "', found '" + word.substr(0, 40) + "'");
        std::vector<double> values;
        while (words >> word) values.push_back(numberOf(word));
        if (values.size() != count)
            fail("'" + key + "' has " + std::to_string(values.size()) + " numbers, expected " +
                 std::to_string(count));
        return values;
    }

    GridAxis axis(const std::string& key)
    {
        const std::vector<double> v = numbers(key, 3);
        const bool isCount = v[2] >= 1.0 && v[2] <= kMostCells && v[2] == std::floor(v[2]);
        if (!isCount || !(v[0] < v[1]))
            fail("'" + key + "': expected begin, end and 1 to " + std::to_string(kMostCells) +
                 " cells");
        return {v[0], v[1], static_cast<int>(v[2])};
    }

    double within(double value, double min, double max, const std::string& what)
    {
        if (!(value >= min && value <= max))
            fail(what + " = " + numberText(value) + ": expected " + numberText(min) + " to " +
                 numberText(max));
        return value;
    }

    void finish()
    {
        if (next("'end'") != "end") fail("expected 'end'");
        std::string rest;
        while (std::getline(lines_, rest))
        {
            ++line_;
            if (rest.find_first_not_of(" \t\r") != std::string::npos)
                fail("expected nothing behind 'end'");
        }
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": " + what);
    }

private:
    double numberOf(const std::string& word) const
    {
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() ||
            !(std::abs(value) <= kLargest))
            fail("'" + word.substr(0, 40) + "' is no finite number of sensible size");
        return value;
    }

    std::istringstream lines_;
    std::string name_;
    int line_ = 0;
};

void readHead(ModelReader& reader, DiscriminatorModel& model)
{
    const std::string first = reader.next("'" + std::string(kFirstLine) + "'");
    if (first.rfind("vdamf discriminator ", 0) != 0)
        reader.fail("this is no discriminator: expected '" + std::string(kFirstLine) + "'");
    if (first != kFirstLine)
        reader.fail("'" + first.substr(0, 40) + "' is of another version: expected '" + kFirstLine +
                    "'; train the model again");
    std::string text = reader.next("'record'");
    for (; text.rfind("record ", 0) == 0; text = reader.next("'record' or 'grid_m'"))
        model.record.push_back(text.substr(7));
    if (text != "grid_m") reader.fail("expected 'record ...' or 'grid_m'");
    model.grid = {reader.axis("x"), reader.axis("y"), reader.axis("z")};
}

void readCalibration(ModelReader& reader, DiscriminatorModel& model)
{
    const std::vector<double> frame = reader.numbers("frame_calibration", 5);
    model.frame = {frame[0], frame[1], frame[2], frame[3], frame[4]};
    const std::vector<double> track = reader.numbers("track_calibration", 5);
    model.track = {reader.within(track[0], 0.0, 1.0, "memory"),
                   reader.within(track[1], 0.0, 1.0, "correlation"), track[2], track[3],
                   reader.within(track[4], 0.1, 50.0, "cap")};
}

// Cells and descriptors stand in rows: by x for the cells, in one line each for the others.
std::vector<std::size_t> rowsOf(const FeatureBlock& block, const DiscriminationGrid& grid)
{
    if (block.name != "cells") return {block.size};
    const auto perRow = static_cast<std::size_t>(grid.x.cells);
    return std::vector<std::size_t>(block.size / perRow, perRow);
}
}  // namespace

DiscriminatorModel untrainedModel(const DiscriminationGrid& grid)
{
    DiscriminatorModel model;
    model.grid = grid;
    model.weights.assign(featureCount(grid), 0.0);
    return model;
}

std::string toText(const DiscriminatorModel& model)
{
    const auto axis = [](const char* key, const GridAxis& a) {
        return line(key, {a.min, a.max, static_cast<double>(a.cells)});
    };
    std::string text = std::string(kFirstLine) + '\n';
    for (const std::string& entry : model.record) text += "record " + entry + '\n';
    text +=
        "grid_m\n" + axis("x", model.grid.x) + axis("y", model.grid.y) + axis("z", model.grid.z);
    const FrameCalibration& f = model.frame;
    text += line("frame_calibration",
                 {f.slope, f.offset, f.slopePerDecade, f.offsetPerDecade, f.prior});
    const TrackCalibration& t = model.track;
    text += line("track_calibration", {t.memory, t.correlation, t.slope, t.offset, t.cap});
    text += line("bias", {model.bias});
    for (const FeatureBlock& block : featureBlocks(model.grid))
    {
        auto from = model.weights.begin() + static_cast<std::ptrdiff_t>(block.first);
        for (const std::size_t count : rowsOf(block, model.grid))
        {
            const auto to = from + static_cast<std::ptrdiff_t>(count);
            text += line(block.name, {from, to});
            from = to;
        }
    }
    return text + "end\n";
}

DiscriminatorModel parseDiscriminatorModel(const std::string& text, const std::string& name)
{
    ModelReader reader(text, name);
    DiscriminatorModel model;
    readHead(reader, model);
    readCalibration(reader, model);
    model.bias = reader.numbers("bias", 1).front();
    for (const FeatureBlock& block : featureBlocks(model.grid))
        for (const std::size_t count : rowsOf(block, model.grid))
        {
            const std::vector<double> row = reader.numbers(block.name, count);
            model.weights.insert(model.weights.end(), row.begin(), row.end());
        }
    reader.finish();
    return model;
}

}  // namespace vdamf
