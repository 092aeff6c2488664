// SPDX-License-Identifier: BSD-3-Clause
// Writes MRPT rawlogs: gz compressed in worker threads, every write checked.
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "vdamf/files/output_file.h"

namespace vdamf
{
/// The bytes of one object as they stand in a rawlog.
std::string serialized(const mrpt::serialization::CSerializable& object);

/// Appends objects to `<path>.partial`; commit() finishes the file and gives it its name. The gz
/// stream is a sequence of members, each a whole number of objects, so that a file cut short
/// after any member still reads to its end; the same input gives the same bytes whatever the
/// number of threads. Errors (full disk, ...) are std::runtime_error that name the file; they may
/// surface in a later call than the write that caused them, at the latest in commit().
class RawlogWriter
{
public:
    struct Options
    {
        int gzLevel = 1;                    ///< 0: plain file, 1..9: gz
        int threads = 2;                    ///< compressing; 0: in the calling thread
        std::size_t memberBytes = 4 << 20;  ///< uncompressed size of a gz member, about
        OutputFile::Existing existing = OutputFile::Existing::Refuse;
        OutputFile::Unfinished unfinished = OutputFile::Unfinished::Discard;
    };

    RawlogWriter(const std::filesystem::path& path, const Options& options);
    ~RawlogWriter();
    RawlogWriter(const RawlogWriter&) = delete;
    RawlogWriter& operator=(const RawlogWriter&) = delete;

    void write(const mrpt::serialization::CSerializable& object);
    void writeBytes(std::string_view serializedObjects);  ///< whole objects
    /// Ends the current member: what was written so far is on its way to the file.
    void endMember();
    /// Ends the current member and waits until all so far is with the operating system.
    void flush();
    void commit();
    /// Gives the file up: nothing stays behind.
    void discard();

    const std::filesystem::path& partialPath() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vdamf
