/// One option's value: its kind and range, read from text and written back. For lab/options.cpp and lab/options_read.cpp only.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lab/options.hpp"

namespace mpm::detail {

using Words = std::vector<std::string>;
using Value = std::variant<double, int, std::vector<int>, std::string, bool>;
using Target = std::variant<double*, int*, std::vector<int>*, std::string*, bool*>;
enum class Kind { number, integer, integers, choice, text, flag };

/// One declared option: the variable it is bound to and what that may hold.
struct Entry {
    std::string name, unit, help;
    Kind kind;
    Target target;
    Value standard;  // the default
    Range range;
    Words allowed;
    bool labelled = true, given = false;

    Value value() const {
        return std::visit([](const auto* bound) { return Value(*bound); }, target);
    }
    void commit(const Value& fresh) const {
        std::visit([&](auto* bound) { *bound = std::get<std::remove_pointer_t<decltype(bound)>>(fresh); }, target);
    }
    bool changed() const { return labelled && value() != standard; }
};

std::string kind_name(Kind kind);
std::string joined(const Words& words, const std::string& between);
std::string value_text(const Value& value);
/// Quotes a text that a config file or a list of settings would otherwise read differently.
std::string quoted(const std::string& text);
/// What an option takes, for messages and help.
std::string allowed_text(const Entry& e);
/// Reads one value, or nothing if it is not allowed.
std::optional<Value> read_value(const Entry& e, const std::string& raw);
/// The message for a value that is not allowed: `who` is the option as the user wrote it.
std::string refusal(const Entry& e, const std::string& who, const std::string& raw);

}  // namespace mpm::detail
