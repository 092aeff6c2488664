// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/sweep_page.h"

namespace vdamf
{
std::string sweepPage(const SweepResults& results, const std::string& title)
{
    return title + tableCsv(results);
}

}  // namespace vdamf
