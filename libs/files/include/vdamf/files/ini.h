// SPDX-License-Identifier: BSD-3-Clause
// Strict ini files: every section and key must be known, every value must parse to its end.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
struct IniEntry
{
    std::string key;
    std::string value;  ///< trimmed
    int line = 0;       ///< 0: not from a file (command line)
};

struct IniSection
{
    std::string name;
    int line = 0;
    std::vector<IniEntry> entries;
};

/// Whether a value that is written to an ini file reads back the same.
bool standsInIni(std::string_view value);
/// What such a value is, for messages.
constexpr const char* kIniText =
    "a text without line break, blank at its ends, or comment mark ('#', ';', '//') at its begin "
    "or behind a blank";

/// A parsed ini file. `[section]`, `key = value`; comments: a line that starts with `#`, `;` or
/// `//`, and anything after ` //`, ` #` or ` ;` behind a value (a blank before the mark). Lines end
/// with a line feed, a carriage return or both. A duplicate section or key, or a line that is
/// neither, is a std::runtime_error "file:line: ...".
class IniDocument
{
public:
    static IniDocument parse(std::string_view text, std::string fileName);
    static IniDocument load(const std::filesystem::path& path);

    /// "section.key=value" from a command line; replaces a value of the file or adds one. Throws
    /// std::runtime_error where the text is not of this form.
    void set(std::string_view assignment);

    const std::string& fileName() const { return fileName_; }
    const std::vector<IniSection>& sections() const { return sections_; }
    const IniSection* find(std::string_view section) const;
    const IniEntry* find(std::string_view section, std::string_view key) const;

    /// "file:line", or "--set"; the file's name for a key that is not there.
    std::string placeOf(std::string_view section, std::string_view key) const;

    /// The file that a key names: a relative name counts from this file's folder, one that came by
    /// set() from the current one.
    std::filesystem::path fileOf(std::string_view section, std::string_view key,
                                 const std::filesystem::path& name) const;

private:
    std::string fileName_;
    std::vector<IniSection> sections_;
};

/// Reads options structs (types/options.h) from a document and keeps the books of what is known.
///
///     IniReader reader(document);
///     reader.read("clustering", options.clustering);
///     reader.finish();  // throws IniError that lists every problem
///
/// Problems found: unknown section or key (with the nearest known one), value that does not parse
/// to its end, bool other than true/false, unknown enum name (with the names), out of range, text
/// of a command line that no ini file can hold. All name file, line, section.key and what was
/// expected. A key that is not in the document leaves its member as it is. Values of keys that end
/// in `_deg` are degrees: `v = value * kPi / 180`.
class IniReader
{
public:
    explicit IniReader(const IniDocument& document) : document_(document) {}

    template <class Options>
    void read(const std::string& section, Options& options)
    {
        beginSection(section);
        Options::visit(options, *this);
    }

    /// For what concerns several values together: notes the problem, which names their keys, where
    /// the condition does not hold. It goes behind the file's name, and the line where there is
    /// one.
    void require(bool condition, const std::string& problem, int line = 0);

    /// The same, behind the places of these keys.
    void require(bool condition, const std::string& problem,
                 const std::vector<std::pair<std::string, std::string>>& keys);

    void finish();

    // Visitors, called by Options::visit.
    void operator()(double& v, const char* key, double min, double max, const char* comment);
    void operator()(int& v, const char* key, int min, int max, const char* comment);
    void operator()(bool& v, const char* key, const char* comment);
    void operator()(std::string& v, const char* key, const char* comment);
    template <class Enum, class = std::enable_if_t<std::is_enum_v<Enum>>>
    void operator()(Enum& v, const char* key, const char* comment)
    {
        std::vector<std::string> names;
        for (const auto& [value, name] : EnumNames<Enum>::names()) names.emplace_back(name);
        const int index = readEnum(key, names, comment);
        if (index >= 0) v = EnumNames<Enum>::names()[static_cast<std::size_t>(index)].first;
    }

private:
    void beginSection(const std::string& section);
    int readEnum(const char* key, const std::vector<std::string>& names, const char* comment);
    const IniEntry* entry(const char* key);
    void problem(const IniEntry& entry, const std::string& expected);
    void findUnknown();

    const IniDocument& document_;
    std::string section_;
    std::map<std::string, std::vector<std::string>> known_;  ///< keys by section
    std::vector<std::string> problems_;
};

/// Thrown by IniReader::finish: one line a problem.
class IniError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Writes options structs as a commented ini text, the exact inverse of IniReader (round trip to
/// the last bit: shortest decimal that reads back the same). Throws std::runtime_error for a text
/// that is not kIniText.
///
///     # largest gap inside a cluster (0.05 to 2)
///     gap_m = 0.4
class IniWriter
{
public:
    template <class Options>
    void write(const std::string& section, const std::string& comment, const Options& options)
    {
        beginSection(section, comment);
        Options::visit(options, *this);
    }

    const std::string& text() const { return text_; }

    void operator()(const double& v, const char* key, double min, double max, const char* comment);
    void operator()(const int& v, const char* key, int min, int max, const char* comment);
    void operator()(const bool& v, const char* key, const char* comment);
    void operator()(const std::string& v, const char* key, const char* comment);
    template <class Enum, class = std::enable_if_t<std::is_enum_v<Enum>>>
    void operator()(const Enum& v, const char* key, const char* comment)
    {
        std::string all;
        const char* name = "";
        for (const auto& [value, text] : EnumNames<Enum>::names())
        {
            all += (all.empty() ? "" : " | ") + std::string(text);
            if (value == v) name = text;
        }
        writeEntry(key, name, std::string(comment) + " (" + all + ")");
    }

private:
    void beginSection(const std::string& section, const std::string& comment);
    void writeEntry(const char* key, const std::string& value, const std::string& comment);

    std::string text_;
};

}  // namespace vdamf
