// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/files/csv.h"

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

std::vector<std::string> cellsOf(std::string_view line)
{
    std::vector<std::string> cells;
    for (;;)
    {
        const std::size_t comma = line.find(',');
        cells.emplace_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}
}  // namespace

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

    std::size_t indexOf(std::string_view column) const
    {
        const auto found = columns.find(column);
        if (found == columns.end()) fail("there is no column '" + std::string(column) + "'");
        return found->second;
    }

    void readHeader(const std::vector<std::string>& required)
    {
        std::optional<std::string_view> header = nextLine();
        constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
        if (header && header->substr(0, 3) == kByteOrderMark) header->remove_prefix(3);
        if (!header || trimmed(*header).empty())
        {
            line = 1;
            fail(std::string(header ? "the first line is empty" : "the file is empty") +
                 "; expected a header line with the column names");
        }
        const std::vector<std::string> names = cellsOf(*header);
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
        state_->cells = cellsOf(*row);
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
    return state_->cells.at(state_->indexOf(column));
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
