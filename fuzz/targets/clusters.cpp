// SPDX-License-Identifier: BSD-3-Clause
// clusters.csv: each cluster fitted, each fit finite.
#include "fit_cluster.h"
#include "fit_table.h"
#include "memory_file.h"
#include "require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    fuzz::mayRefuse(
        [&]
        {
            ClusterTable table(file.path());
            while (const auto cluster = table.next())
            {
                const ClusterFit fit = fitCluster(*cluster, MeasureOptions{});
                toCsv(*cluster, fit);
                fuzz::require(fit.measurement || !fit.reason.empty(), "no fit has a reason");
                fuzz::require(!fit.measurement || fit.measurement->covariance.allFinite(),
                              "a fit is finite");
            }
        });
    return 0;
}
