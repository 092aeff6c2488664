// SPDX-License-Identifier: BSD-3-Clause
// A large value that is passed on as cheaply as a pointer.
#pragma once

#include <memory>
#include <utility>

namespace vdamf
{
/// Copied as its value is, moved without it: what was moved from may be assigned or destroyed only.
template <class Value>
class Boxed
{
public:
    Boxed() : value_(std::make_unique<Value>()) {}
    Boxed(const Boxed& other) : value_(std::make_unique<Value>(*other)) {}
    Boxed(Boxed&&) noexcept = default;
    Boxed& operator=(const Boxed& other) { return *this = Boxed(other); }
    Boxed& operator=(Boxed&&) noexcept = default;
    ~Boxed() = default;

    Value& operator*() { return *value_; }
    const Value& operator*() const { return *value_; }
    Value* operator->() { return value_.get(); }
    const Value* operator->() const { return value_.get(); }

private:
    std::unique_ptr<Value> value_;
};

}  // namespace vdamf
