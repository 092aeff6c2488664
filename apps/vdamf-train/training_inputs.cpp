// SPDX-License-Identifier: BSD-3-Clause
#include "training_inputs.h"

namespace vdamf
{
void declareInputs(CLI::App& command, TrainingInputs& inputs, const std::string& name,
                   const std::string& meaning)
{
    command.add_option(name, inputs.list, meaning)->required();
    command.add_option("-c,--config", inputs.config, "configuration of the tracker (ini)");
    command.add_option("--set", inputs.set, "section.key=value over the " + name + " (repeatable)")
        ->allow_extra_args(false);
}

IniDocument readList(const TrainingInputs& inputs)
{
    IniDocument document = IniDocument::load(inputs.list);
    for (const std::string& assignment : inputs.set) document.set(assignment);
    return document;
}

}  // namespace vdamf
