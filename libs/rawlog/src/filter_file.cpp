// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/filter_file.h"

#include <algorithm>
#include <stdexcept>

#include "vdamf/files/ini.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr int kVersion = 1;
const std::string kHead = "filters";
const std::string kFilter = "filter ";
const std::string kEnd = "end";

struct Head
{
    int version = kVersion;
    FilterRecord record;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.version, "version", kVersion, kVersion, "of this format");
        FilterRecord::visit(self.record, field);
    }
};

/// The last section: a file without it is not whole.
struct End
{
    bool whole = true;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.whole, "whole", "this is the end of the file");
    }
};

/// Visitor that asks for every key of an options struct in a section.
struct AllKeys
{
    IniReader& reader;
    const IniSection& section;

    template <class Value, class... More>
    void operator()(Value&, const char* key, const More&...) const
    {
        const bool isThere = std::any_of(section.entries.begin(), section.entries.end(),
                                         [&](const IniEntry& e) { return e.key == key; });
        reader.require(isThere, "[" + section.name + "] has no '" + key + "': is the file whole?",
                       section.line);
    }
};

template <class Options>
void readWhole(IniReader& reader, const IniDocument& document, const std::string& name,
               Options& options)
{
    reader.read(name, options);
    const IniSection* section = document.find(name);
    reader.require(section != nullptr, "has no section [" + name + "]: is the file whole?");
    if (section != nullptr) Options::visit(options, AllKeys{reader, *section});
}

void checkVersion(const IniDocument& document)
{
    const IniSection* head = document.find(kHead);
    if (head == nullptr)
        throw std::runtime_error(document.fileName() + ": these are no filters: expected [" +
                                 kHead + "]");
    for (const IniEntry& entry : head->entries)
        if (entry.key == "version" && entry.value != std::to_string(kVersion))
            throw std::runtime_error(document.fileName() + ":" + std::to_string(entry.line) +
                                     ": version = " + entry.value + ": expected " +
                                     std::to_string(kVersion) + "; train the filters again");
}
}  // namespace

std::string toText(const FilterBank& bank)
{
    IniWriter writer;
    writer.write(kHead, "Learned filters", Head{kVersion, bank.record});
    for (const TypedFilter& filter : bank.filters)
        for (const auto& [type, name] : EnumNames<VehicleType>::names())
            if (type == filter.type) writer.write(kFilter + name, "", filter);
    writer.write(kEnd, "", End{});
    return writer.text();
}

FilterBank parseFilterBank(std::string_view text, const std::string& name)
{
    const IniDocument document = IniDocument::parse(text, name);
    checkVersion(document);
    IniReader reader(document);
    Head head;
    readWhole(reader, document, kHead, head);
    FilterBank bank;
    bank.record = head.record;
    for (const auto& [type, typeName] : EnumNames<VehicleType>::names())
    {
        if (document.find(kFilter + typeName) == nullptr) continue;
        TypedFilter filter;
        filter.type = type;
        readWhole(reader, document, kFilter + typeName, filter);
        bank.filters.push_back(filter);
    }
    reader.require(!bank.filters.empty(),
                   "has no filter: expected a section [filter any], or one of car, van, "
                   "truck, two_wheeler");
    End end;
    readWhole(reader, document, kEnd, end);
    reader.require(end.whole, "[end] says that the file is not whole");
    reader.finish();
    return bank;
}

MeasureOptions withFilterFromFile(const MeasureOptions& options)
{
    if (options.filterFile.empty()) return options;
    constexpr std::size_t kLargest = std::size_t{1} << 20;
    try
    {
        const auto bank = std::make_shared<const FilterBank>(
            parseFilterBank(readTextFile(options.filterFile, kLargest), options.filterFile));
        MeasureOptions own = withFilter(options, commonFilter(*bank).parameters);
        own.bank = bank;
        return own;
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error("measurement.filter_file: " + std::string(error.what()));
    }
}

}  // namespace vdamf
