// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/optimise.h"

#include <algorithm>
#include <exception>
#include <map>
#include <nlopt.hpp>
#include <stdexcept>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
nlopt::algorithm algorithmOf(SweepOptimiser optimiser)
{
    switch (optimiser)
    {
        case SweepOptimiser::Bobyqa:
            return nlopt::LN_BOBYQA;
        case SweepOptimiser::NelderMead:
            return nlopt::LN_NELDERMEAD;
        case SweepOptimiser::Subplex:
            return nlopt::LN_SBPLX;
        case SweepOptimiser::Direct:
            return nlopt::GN_DIRECT_L;
    }
    throw std::logic_error("unknown optimiser");
}

// The search's view of the settings: a function on the unit cube.
class Landscape
{
public:
    Landscape(const std::vector<SweptKey>& keys, std::size_t count, const SettingScore& score)
        : keys_(keys), count_(count), score_(score)
    {
    }

    static double evaluate(const std::vector<double>& point, std::vector<double>&, void* landscape)
    {
        return static_cast<Landscape*>(landscape)->at(point);
    }

    std::exception_ptr error() const { return error_; }

private:
    double at(const std::vector<double>& point)
    {
        const SweepSetting setting = settingAt(keys_, point);
        const auto known = scores_.find(setting.values);
        if (known != scores_.end()) return known->second;
        if (scores_.size() == count_) throw nlopt::forced_stop();
        try
        {
            const std::optional<double> score = score_(setting);
            // Not the largest number: models of the function must stay usable beside a failure.
            const double value = score ? *score : worst_ - 1.0;
            worst_ = scores_.empty() ? value : std::min(worst_, value);
            scores_[setting.values] = value;
            return value;
        }
        catch (...)
        {
            error_ = std::current_exception();
            throw nlopt::forced_stop();
        }
    }

    const std::vector<SweptKey>& keys_;
    std::size_t count_;
    const SettingScore& score_;
    std::map<std::vector<std::string>, double> scores_;
    double worst_ = 0.0;
    std::exception_ptr error_;
};
}  // namespace

void optimiseSettings(const std::vector<SweptKey>& keys, SweepOptimiser algorithm,
                      std::size_t count, const SettingScore& score)
{
    Landscape landscape(keys, count, score);
    nlopt::opt search(algorithmOf(algorithm), static_cast<unsigned>(keys.size()));
    search.set_lower_bounds(0.0);
    search.set_upper_bounds(1.0);
    search.set_initial_step(0.25);
    search.set_xtol_abs(1e-3);
    // Settings met again cost nothing, but a search that only meets them again must end.
    search.set_maxeval(static_cast<int>(std::min<std::size_t>(1000000, 50 * count)));
    search.set_max_objective(&Landscape::evaluate, &landscape);
    std::vector<double> point(keys.size(), 0.5);
    double best = 0.0;
    try
    {
        search.optimize(point, best);
    }
    catch (const nlopt::forced_stop&)
    {
        if (landscape.error()) std::rethrow_exception(landscape.error());
    }
    catch (const nlopt::roundoff_limited&)
    {
        return;  // as near as it gets
    }
}

void checkSearchable(const std::vector<SweptKey>& keys, SweepOptimiser algorithm)
{
    if (algorithm == SweepOptimiser::Bobyqa && keys.size() < 2)
        throw std::runtime_error(
            "optimiser = bobyqa needs two keys or more; take nelder_mead for one");
    for (const SweptKey& key : keys)
    {
        double last = 0.0;
        for (std::size_t i = 0; i < key.values.size(); ++i)
        {
            const std::optional<double> number = parseNumber(key.values[i]);
            if (!number || (i > 0 && *number <= last))
                throw std::runtime_error(key.name +
                                         ": plan = optimise needs rising numbers, for example "
                                         "'0.1 : 0.3' or '1 : 1 : 9'");
            last = *number;
        }
    }
}

}  // namespace vdamf
