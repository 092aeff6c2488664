// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/linear_classifier.h"

#include <linear.h>

#include <array>
#include <cassert>
#include <memory>
#include <stdexcept>

namespace vdamf
{
namespace
{
constexpr double kBias = 1.0;

/// The samples as liblinear wants them: rows of nodes, indices from 1, ended by -1.
struct LinearProblem
{
    std::vector<feature_node> nodes;
    std::vector<feature_node*> rows;
    std::vector<double> labels;
    problem view{};
};

std::unique_ptr<LinearProblem> problemOf(const std::vector<const ObjectSample*>& samples,
                                         std::size_t featureCount)
{
    auto p = std::make_unique<LinearProblem>();
    const int biasIndex = static_cast<int>(featureCount) + 1;
    std::vector<std::size_t> begins;
    const ObjectSample* last = nullptr;
    for (const ObjectSample* sample : samples)
    {
        p->labels.push_back(sample->label == ObjectLabel::Vehicle ? 1.0 : -1.0);
        // One that counts several times stands there once.
        begins.push_back(sample == last ? begins.back() : p->nodes.size());
        if (sample == last) continue;
        last = sample;
        for (const SparseFeature& f : sample->features)
            p->nodes.push_back({static_cast<int>(f.index) + 1, static_cast<double>(f.value)});
        p->nodes.push_back({biasIndex, kBias});
        p->nodes.push_back({-1, 0.0});
    }
    for (const std::size_t begin : begins) p->rows.push_back(&p->nodes[begin]);
    p->view = {static_cast<int>(samples.size()), biasIndex, p->labels.data(), p->rows.data(),
               kBias};
    return p;
}

void printNothing(const char* /*text*/) {}

/// liblinear prints by a function that all threads share: to be set before the first one starts.
const bool kIsSilent = (set_print_string_function(printNothing), true);
}  // namespace

double LinearClassifier::score(const std::vector<SparseFeature>& features) const
{
    double sum = bias;
    for (const SparseFeature& f : features) sum += weights[f.index] * static_cast<double>(f.value);
    return sum;
}

LinearClassifier trainLinear(const std::vector<const ObjectSample*>& samples,
                             std::size_t featureCount, double cost)
{
    const std::unique_ptr<LinearProblem> p = problemOf(samples, featureCount);
    double vehicles = 0.0;
    for (const double label : p->labels) vehicles += label > 0.0 ? 1.0 : 0.0;
    const double all = static_cast<double>(samples.size());
    if (vehicles == 0.0 || vehicles == all)
        throw std::runtime_error("a classifier needs samples of both vehicles and clutter");
    std::array<int, 2> labels = {1, -1};
    std::array<double, 2> weights = {0.5 * all / vehicles, 0.5 * all / (all - vehicles)};
    parameter options{};
    options.solver_type = L2R_L2LOSS_SVC;
    options.eps = 0.003;
    options.C = cost;
    options.nr_weight = 2;
    options.weight_label = labels.data();
    options.weight = weights.data();
    assert(kIsSilent);
    if (const char* problem = check_parameter(&p->view, &options))
        throw std::runtime_error(std::string("liblinear: ") + problem);
    const auto release = [](model* m) { free_and_destroy_model(&m); };
    const std::unique_ptr<model, decltype(release)> trained(train(&p->view, &options), release);
    LinearClassifier classifier;
    classifier.bias = kBias * get_decfun_bias(trained.get(), 0);
    for (int i = 1; i <= static_cast<int>(featureCount); ++i)
        classifier.weights.push_back(get_decfun_coef(trained.get(), i, 0));
    // liblinear names the label of the first sample first.
    if (trained->label[0] < 0)
    {
        classifier.bias = -classifier.bias;
        for (double& w : classifier.weights) w = -w;
    }
    return classifier;
}

}  // namespace vdamf
