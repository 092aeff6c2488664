// SPDX-License-Identifier: BSD-3-Clause
// Strict CSV tables: one header line, columns by name in any order, more columns than needed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vdamf/files/numbers.h"

namespace vdamf
{
/// The text as a cell holds it, to be read back the same: without blanks at its ends, and `;` for
/// commas, quotation marks and line breaks.
std::string cellText(std::string_view text);
/// What a cell can hold as it is, for messages.
constexpr const char* kCellText =
    "a text without comma, quotation mark, line break, or blank at its ends";

/// Reads a table row by row in constant memory. Cells are separated by commas; they may
/// stand in quotes, but hold kCellText or nothing where they are asked for. Blanks around
/// them do not count. Every error is a std::runtime_error that names file, line and
/// column: a missing or doubled column, a bad number, a row of another length, an empty file.
class CsvReader
{
public:
    /// Opens the file and reads its header. `required`: columns that must exist.
    CsvReader(const std::filesystem::path& path, const std::vector<std::string>& required);
    ~CsvReader();
    CsvReader(const CsvReader&) = delete;
    CsvReader& operator=(const CsvReader&) = delete;

    bool next();  ///< to the next row; false at the end (blank lines are skipped)
    int line() const;
    bool hasColumn(std::string_view column) const;

    // Values of the current row by column name.
    const std::string& text(std::string_view column) const;
    double number(std::string_view column) const;  ///< finite
    std::int64_t integer(std::string_view column) const;
    std::optional<double> optionalNumber(std::string_view column) const;  ///< nothing if empty

    /// An error about the current row, for checks of the caller.
    [[noreturn]] void fail(std::string_view column, const std::string& what) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vdamf
