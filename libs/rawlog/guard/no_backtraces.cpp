// SPDX-License-Identifier: BSD-3-Clause
// MRPT looks up the names of all functions on the stack wherever it throws, which each damaged
// object makes it do several times; nobody reads them, and it takes more time than the rest of the
// reading. Part of programs only, never of a library.
#include <mrpt/core/backtrace.h>

void mrpt::callStackBackTrace(TCallStackBackTrace& /*names*/, const unsigned int /*skipped*/,
                              const unsigned int /*most*/) noexcept
{
}
