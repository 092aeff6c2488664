// SPDX-License-Identifier: BSD-3-Clause
// Where the next entry of a rawlog begins.
#pragma once

#include <cstddef>
#include <string>

#include "entry_window.h"

namespace vdamf
{
/// Position in the window of the first begin of an entry from `from` (at least 1) on, below
/// `limit`; the end of the stream, or `limit`, where there is none. `className`: begins also an
/// entry where it stands behind an end flag.
std::size_t findEntry(EntryWindow& window, std::size_t from, std::size_t limit,
                      const std::string& className = {});

}  // namespace vdamf
