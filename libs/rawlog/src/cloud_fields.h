// SPDX-License-Identifier: BSD-3-Clause
// The records of a file of points: which field is what, and numbers from bytes or text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vdamf/rawlog/cloud_file.h"

namespace vdamf
{
struct CloudField
{
    std::string name;
    char type = 'F';         ///< F floating point, I signed, U unsigned
    std::size_t size = 4;    ///< of one number, bytes
    std::size_t count = 1;   ///< numbers in the field
    std::size_t offset = 0;  ///< in the record, bytes

    std::size_t bytes() const { return size * count; }
};

/// A number at an address, which need not be aligned. The type is one of: F of 4, 8; I, U of 1, 2,
/// 4, 8 bytes.
double numberAt(const char* at, const CloudField& field, bool bigEndian);
bool isNumberType(char type, std::size_t size);

/// Takes records one by one, keeps the fields that matter.
class CloudBuilder
{
public:
    /// Sets the fields' offsets aside, they are the caller's. Throws std::runtime_error
    /// "name: ..." where x, y or z is missing or doubled.
    CloudBuilder(const std::vector<CloudField>& fields, const std::string& name, PointTime unit);

    void reserve(std::size_t points);
    /// `value(i)` gives the first number of field i.
    template <class Value>
    void add(const Value& value)
    {
        append(value(x_), value(y_), value(z_), intensity_ ? value(*intensity_) : 0.0,
               time_ ? value(*time_) : 0.0);
    }
    FileCloud finish() &&;

private:
    void append(double x, double y, double z, double intensity, double time);

    std::size_t x_ = 0;
    std::size_t y_ = 0;
    std::size_t z_ = 0;
    std::optional<std::size_t> intensity_;
    std::optional<std::size_t> time_;
    double secondsPerUnit_ = 1.0;
    FileCloud cloud_;
};

/// Splits a text into lines and words, and knows where it is.
class TextCursor
{
public:
    TextCursor(std::string_view bytes, std::string name) : rest_(bytes), name_(std::move(name)) {}

    /// The next line without its end; false at the end.
    bool nextLine(std::string_view& line);
    /// What stands behind the last line.
    std::string_view rest() const { return rest_; }
    /// "name:line".
    std::string where() const { return name_ + ":" + std::to_string(line_); }
    [[noreturn]] void fail(const std::string& what) const;

private:
    std::string_view rest_;
    std::string name_;
    int line_ = 0;
};

std::vector<std::string_view> wordsOf(std::string_view line);

/// A number of an ascii record; nan where it is none of those that the formats allow.
std::optional<double> numberFrom(std::string_view word);

}  // namespace vdamf
