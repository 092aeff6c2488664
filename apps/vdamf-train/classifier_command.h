// SPDX-License-Identifier: BSD-3-Clause
// The command line of `vdamf-train classifier`.
#pragma once

#include <CLI/CLI.hpp>

#include "classifier.h"
#include "training_inputs.h"

namespace vdamf
{
struct ClassifierCommandLine
{
    TrainingInputs inputs;
    ClassifierJob job;
};

void declareClassifier(CLI::App& command, ClassifierCommandLine& line);

/// Reads what the command line names. Throws std::runtime_error.
ClassifierJob prepared(const ClassifierCommandLine& line);

}  // namespace vdamf
