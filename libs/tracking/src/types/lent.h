// SPDX-License-Identifier: BSD-3-Clause
// A large value that is often there already.
#pragma once

#include <optional>
#include <utility>

namespace vdamf
{
/// A value of its own, or one that stands elsewhere for as long as this is used.
template <class Value>
class Lent
{
public:
    Lent() : own_(Value()) {}
    Lent(Value own) : own_(std::move(own)) {}
    static Lent from(const Value& elsewhere)
    {
        Lent lent;
        lent.own_.reset();
        lent.elsewhere_ = &elsewhere;
        return lent;
    }

    const Value& operator*() const { return own_ ? *own_ : *elsewhere_; }
    const Value* operator->() const { return &**this; }

private:
    std::optional<Value> own_;
    const Value* elsewhere_ = nullptr;
};

}  // namespace vdamf
