#include "lab/options_value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lab/record.hpp"

namespace mpm::detail {
namespace {

constexpr std::size_t max_items = 1000;

bool has_control(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
}

/// The whole of a text as a number, with an optional leading plus.
template <class Number>
std::optional<Number> read_number(const std::string& text) {
    const char* first = text.data();
    const char* const last = first + text.size();
    if (text.size() > 1 && *first == '+' && first[1] != '-') ++first;
    Number x{};
    const auto [end, error] = std::from_chars(first, last, x);
    if (error != std::errc() || end != last || !std::isfinite(static_cast<double>(x))) return {};
    return x;
}

std::optional<std::vector<int>> read_list(const std::string& text, const Range& range) {
    std::vector<int> items;
    for (std::size_t from = 0; items.size() < max_items;) {
        const std::size_t comma = text.find(',', from);
        const auto item = read_number<int>(text.substr(from, comma == std::string::npos ? comma : comma - from));
        if (!item || !range.contains(*item)) return {};
        items.push_back(*item);
        if (comma == std::string::npos) return items;
        from = comma + 1;
    }
    return {};  // too many
}

}  // namespace

std::string kind_name(Kind kind) {
    static const Words names = {"number", "integer", "integers", "choice", "text", "flag"};
    return names[static_cast<std::size_t>(kind)];
}

std::string joined(const Words& words, const std::string& between) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += between;
        text += words[i];
    }
    return text;
}

std::string value_text(const Value& value) {
    if (const auto* x = std::get_if<double>(&value)) return number_text(*x);
    if (const auto* i = std::get_if<int>(&value)) return std::to_string(*i);
    if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
    if (const auto* s = std::get_if<std::string>(&value)) return *s;
    Words items;
    for (const int i : std::get<std::vector<int>>(value)) items.push_back(std::to_string(i));
    return joined(items, ",");
}

std::string quoted(const std::string& text) {
    const bool plain = text.find_first_of("#;\"") == std::string::npos;
    if (plain && !text.empty() && text.front() != ' ' && text.back() != ' ') return text;
    std::string result = "\"";
    for (const char c : text) result += (c == '"' || c == '\\') ? std::string("\\") + c : std::string(1, c);
    return result + '"';
}

std::string allowed_text(const Entry& e) {
    const std::string range = e.range.text();
    const bool bounded = range != Range{}.text();
    switch (e.kind) {
        case Kind::number:
            return range;
        case Kind::integer:
            return bounded ? "whole numbers " + range : "any whole number";
        case Kind::integers:
            return "1 to 1000 whole numbers " + (bounded ? range + " " : std::string()) + "with commas between";
        case Kind::choice:
            return joined(e.allowed, ", ");
        case Kind::flag:
            return "true, false, on, off, 1, 0";
        case Kind::text:
            break;
    }
    return "text without control characters";
}

std::optional<Value> read_value(const Entry& e, const std::string& raw) {
    switch (e.kind) {
        case Kind::number:
            if (const auto x = read_number<double>(raw); x && e.range.contains(*x)) return *x;
            break;
        case Kind::integer:
            if (const auto i = read_number<int>(raw); i && e.range.contains(*i)) return *i;
            break;
        case Kind::integers:
            if (auto list = read_list(raw, e.range)) return *std::move(list);
            break;
        case Kind::choice:
            if (std::find(e.allowed.begin(), e.allowed.end(), raw) != e.allowed.end()) return raw;
            break;
        case Kind::text:
            if (!has_control(raw)) return raw;
            break;
        case Kind::flag:
            if (raw == "true" || raw == "1" || raw == "on") return true;
            if (raw == "false" || raw == "0" || raw == "off") return false;
    }
    return {};
}

std::string refusal(const Entry& e, const std::string& who, const std::string& raw) {
    std::string text = who + " = " + one_line(raw) + ": allowed " + allowed_text(e);
    const std::string near = e.kind == Kind::choice ? nearest(raw, e.allowed) : "";
    if (!near.empty()) text += " (did you mean " + near + "?)";
    return text + ", default " + one_line(quoted(value_text(e.standard)));
}

}  // namespace mpm::detail

namespace mpm {

bool Range::contains(double x) const { return std::isfinite(x) && (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }

std::string Range::text() const {
    const bool below = std::isfinite(low), top = std::isfinite(high);
    if (!below && !top) return "any number";
    if (!top) return (low_open ? "> " : ">= ") + number_text(low);
    if (!below) return (high_open ? "< " : "<= ") + number_text(high);
    const std::string both = number_text(low) + " ... " + number_text(high);
    if (low_open && high_open) return both + " (ends excluded)";
    return low_open ? both + " (" + number_text(low) + " excluded)" : high_open ? both + " (" + number_text(high) + " excluded)" : both;
}

Range any() { return {}; }
Range above(double low) { return {.low = low, .low_open = true}; }
Range at_least(double low) { return {.low = low}; }
Range between(double low, double high) { return {.low = low, .high = high}; }

/// Edit distance with swaps of neighbours, so that "mdoe" is one step from "mode".
std::string nearest(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    if (word.size() > 60) return best;
    std::size_t least = 2 + word.size() / 4;  // from here on too far
    for (const std::string& other : known) {
        const std::size_t n = word.size(), m = other.size();
        std::vector<std::vector<std::size_t>> d(n + 1, std::vector<std::size_t>(m + 1));
        for (std::size_t i = 0; i <= n; ++i)
            for (std::size_t j = 0; j <= m; ++j) {
                if (i == 0 || j == 0) {
                    d[i][j] = i + j;
                    continue;
                }
                const std::size_t differ = word[i - 1] != other[j - 1] ? 1 : 0;
                d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + differ});
                if (i > 1 && j > 1 && word[i - 1] == other[j - 2] && word[i - 2] == other[j - 1])
                    d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        if (d[n][m] < std::min(least, std::max(n, m))) least = d[n][m], best = other;
    }
    return best;
}

}  // namespace mpm
