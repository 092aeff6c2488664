// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/csv.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <system_error>

#include "vdamf/files/nearest_name.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kLongestLine = 64 << 10;
constexpr std::string_view kNotInCells = ",\"\r\n";

/// Takes a cell in quotes, of which two stand for one, from the front; nothing where they stay open
/// or something but a comma stands behind them.
std::optional<std::string> takeQuoted(std::string_view& line)
{
    std::string cell;
    for (std::size_t i = 1; i < line.size(); ++i)
    {
        const bool isQuote = line[i] == '"';
        const bool isDoubled = isQuote && i + 1 < line.size() && line[i + 1] == '"';
        if (isQuote && !isDoubled)
        {
            const std::size_t comma = std::min(line.find(',', i), line.size());
            if (!trimmed(line.substr(i + 1, comma - i - 1)).empty()) return std::nullopt;
            line.remove_prefix(comma);
            return std::string(trimmed(cell));
        }
        cell += line[i];
        i += isDoubled ? 1 : 0;
    }
    return std::nullopt;
}

std::string takePlain(std::string_view& line)
{
    const std::size_t comma = std::min(line.find(','), line.size());
    const std::string cell(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma);
    return cell;
}

/// Nothing where quotes are wrong.
std::optional<std::vector<std::string>> cellsOf(std::string_view line)
{
    std::vector<std::string> cells;
    for (;;)
    {
        const std::size_t begin = line.find_first_not_of(" \t");
        const bool isQuoted = begin != std::string_view::npos && line[begin] == '"';
        if (isQuoted) line.remove_prefix(begin);
        std::optional<std::string> cell = isQuoted ? takeQuoted(line) : takePlain(line);
        if (!cell) return std::nullopt;
        cells.push_back(std::move(*cell));
        if (line.empty()) return cells;
        line.remove_prefix(1);
    }
}
}  // namespace

std::string cellText(std::string_view text)
{
    std::string cell(trimmed(text));
    for (char& c : cell)
        if (kNotInCells.find(c) != std::string_view::npos) c = ';';
    return cell;
}

struct CsvReader::State
{
    std::string fileName;
    std::ifstream file;
    std::string buffer = std::string(kLongestLine, '\0');
    int line = 0;
    std::map<std::string, std::size_t, std::less<>> columns;
    std::vector<std::string> cells;

    [[noreturn]] void fail(const std::string& what) const
    {
        throw std::runtime_error(fileName + ":" + std::to_string(line) + ": " + what);
    }

    // Nothing at the end of the file.
    std::optional<std::string_view> nextLine()
    {
        errno = 0;
        file.getline(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        const auto count = static_cast<std::size_t>(file.gcount());
        if (file.bad())
        {
            throw std::runtime_error(fileName +
                                     ": cannot read: " + std::system_category().message(errno));
        }
        if (file.eof() && count == 0) return std::nullopt;
        ++line;
        if (file.fail()) fail("the line is too long for a table; is this a CSV file?");
        return std::string_view(buffer.data(), file.eof() ? count : count - 1);
    }

    std::vector<std::string> checkedCells(std::string_view row) const
    {
        std::optional<std::vector<std::string>> found = cellsOf(row);
        if (!found)
            fail(
                "a cell in quotes does not end in this line, or something stands behind its "
                "quotes");
        return std::move(*found);
    }

    std::size_t indexOf(std::string_view column) const
    {
        const auto found = columns.find(column);
        if (found == columns.end()) fail("there is no column '" + std::string(column) + "'");
        return found->second;
    }

    void readHeader(const std::vector<std::string>& required)
    {
        std::optional<std::string_view> header = nextLine();
        if (header) header = withoutByteOrderMark(*header);
        if (!header || trimmed(*header).empty())
        {
            line = 1;
            fail(std::string(header ? "the first line is empty" : "the file is empty") +
                 "; expected a header line with the column names");
        }
        const std::vector<std::string> names = checkedCells(*header);
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            if (!columns.emplace(names[i], i).second)
                fail("column " + inQuotes(names[i]) + " twice");
        }
        for (const std::string& name : required)
        {
            if (hasColumn(name)) continue;
            const std::string nearest = nearestName(name, names);
            fail("the column '" + name + "' is missing" +
                 (nearest.empty() ? "" : " (is it '" + nearest + "'?)"));
        }
    }

    bool hasColumn(std::string_view name) const { return columns.find(name) != columns.end(); }
};

CsvReader::CsvReader(const std::filesystem::path& path, const std::vector<std::string>& required)
    : state_(std::make_unique<State>())
{
    state_->fileName = path.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
    {
        throw std::runtime_error(path.string() + ": this is a folder; name a CSV file");
    }
    errno = 0;
    state_->file.open(path, std::ios::binary);
    if (!state_->file)
    {
        throw std::runtime_error(path.string() +
                                 ": cannot read: " + std::system_category().message(errno));
    }
    state_->readHeader(required);
}

CsvReader::~CsvReader() = default;

bool CsvReader::next()
{
    while (const std::optional<std::string_view> row = state_->nextLine())
    {
        if (trimmed(*row).empty()) continue;
        state_->cells = state_->checkedCells(*row);
        if (state_->cells.size() == state_->columns.size()) return true;
        state_->fail("expected " + std::to_string(state_->columns.size()) +
                     " cells as in the header, found " + std::to_string(state_->cells.size()));
    }
    return false;
}

int CsvReader::line() const
{
    return state_->line;
}

bool CsvReader::hasColumn(std::string_view column) const
{
    return state_->hasColumn(column);
}

const std::string& CsvReader::text(std::string_view column) const
{
    const std::string& cell = state_->cells.at(state_->indexOf(column));
    if (cell.find_first_of(",\"") == std::string::npos) return cell;
    fail(column, "a comma or a quote inside of a cell is not taken, found " + inQuotes(cell));
}

double CsvReader::number(std::string_view column) const
{
    const std::optional<double> value = parseNumber(text(column));
    if (!value) fail(column, "expected a finite number, found " + inQuotes(text(column)));
    return *value;
}

std::int64_t CsvReader::integer(std::string_view column) const
{
    const std::optional<std::int64_t> value = parseInteger(text(column));
    if (!value) fail(column, "expected a whole number, found " + inQuotes(text(column)));
    return *value;
}

std::optional<double> CsvReader::optionalNumber(std::string_view column) const
{
    if (text(column).empty()) return std::nullopt;
    return number(column);
}

void CsvReader::fail(std::string_view column, const std::string& what) const
{
    state_->fail("column '" + std::string(column) + "': " + what);
}

}  // namespace vdamf
