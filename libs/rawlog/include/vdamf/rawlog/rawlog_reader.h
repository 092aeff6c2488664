// SPDX-License-Identifier: BSD-3-Clause
// Reads MRPT rawlogs as a stream: both formats, plain or gz, past unknown and damaged objects.
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "vdamf/rawlog/vehicle_movement.h"

namespace vdamf
{
/// One top-level object of a rawlog.
struct RawlogEntry
{
    enum class Kind
    {
        Object,   ///< read whole
        Null,     ///< a null object
        Unknown,  ///< a class that this MRPT does not know, or bytes up to the next known object
        Damaged,  ///< an object that could not be read, with the bytes up to the next known object
        Wrapper,  ///< head or tail of a whole rawlog object: what it holds are entries between them
        Action    ///< an action or a collection of them, whole but not parsed: a corrupt one can
                  ///< crash MRPT's parser
    };
    Kind kind = Kind::Object;
    std::string bytes;                               ///< as they stand in the (uncompressed) file
    mrpt::serialization::CSerializable::Ptr object;  ///< null unless kind is Object
    std::optional<VehicleMovement> movement;         ///< of an Action that tells one
    std::uint64_t offset = 0;                        ///< of the first byte, uncompressed
    std::string problem;                             ///< why, for Unknown and Damaged
};

/// What a reader met so far.
struct RawlogSummary
{
    std::uint64_t objects = 0;  ///< with actions
    std::uint64_t nulls = 0;
    std::uint64_t unknown = 0;
    std::uint64_t damaged = 0;
    std::uint64_t bytes = 0;            ///< uncompressed
    std::vector<std::string> problems;  ///< the first 20, each with its offset
    bool truncated = false;             ///< the file ends inside an object or its gz stream breaks
    std::string truncation;             ///< what was met there
};

/// The system could not read on: a failing disk or network, not the end of the file.
class ReadError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Streams the entries of a rawlog in file order. Memory holds one entry at a time.
class RawlogReader
{
public:
    /// Opens the file. Throws std::runtime_error that names it: missing, unreadable, a folder,
    /// empty, or without any rawlog object near its start ("not a rawlog").
    explicit RawlogReader(const std::filesystem::path& path);
    ~RawlogReader();
    RawlogReader(const RawlogReader&) = delete;
    RawlogReader& operator=(const RawlogReader&) = delete;

    /// The next entry, or nothing at the end of the file (or where a truncated file ends, or where
    /// 1 GB of bytes held no object).
    /// Concatenated `bytes` of all entries are the whole uncompressed file.
    /// Throws ReadError behind the last of the entries that could be read.
    std::optional<RawlogEntry> next();

    const RawlogSummary& summary() const;
    /// Read so far, 0..1, by compressed bytes: for progress bars.
    double progress() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vdamf
