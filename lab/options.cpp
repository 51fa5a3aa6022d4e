#include "lab/options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>

#include "lab/options_read.hpp"
#include "lab/options_value.hpp"
#include "lab/record.hpp"

namespace mpm {

using namespace detail;

namespace {

constexpr std::size_t max_label = 80;

bool holds(const Words& words, const std::string& word) { return std::find(words.begin(), words.end(), word) != words.end(); }

/// A text in letters, digits and ._+- only.
std::string safe(std::string text) {
    for (char& c : text)
        if (!((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' || c == '_' || c == '+' || c == '-'))
            c = '-';
    return text;
}

/// Eight hexadecimal digits that tell long texts apart (FNV-1a).
std::string short_hash(const std::string& text) {
    std::uint32_t hash = 2166136261u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08lx", static_cast<unsigned long>(hash));
    return digits;
}

}  // namespace

struct Options::Impl {
    std::string program, purpose;
    std::vector<Entry> entries;
    std::vector<std::pair<std::string, std::string>> contradictions;
    Words asked;

    Words names() const {
        Words all;
        for (const Entry& e : entries) all.push_back(e.name);
        return all;
    }
    Entry& entry(const std::string& name) {
        for (Entry& e : entries)
            if (e.name == name) return e;
        throw std::logic_error("no option is named " + name);
    }
    /// Adds an option; a name twice or a default that is not allowed is the program's mistake.
    void add(Entry e) {
        e.standard = e.value();
        const Words taken = names();
        const bool odd = e.name.empty() || e.name != safe(e.name) || e.name.front() == '-';
        if (odd || holds(taken, e.name) || holds(always, e.name)) throw std::logic_error("option name cannot be used: " + e.name);
        if (read_value(e, value_text(e.standard)) != e.standard) throw std::logic_error("default of option " + e.name + " is not allowed");
        entries.push_back(std::move(e));
    }
    bool given(const std::string& name) const {
        return std::any_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == name && e.given; });
    }
    /// Of a contradicting pair the second is in use unless the first was given.
    bool idle(const Entry& e) const {
        return std::any_of(contradictions.begin(), contradictions.end(),
                           [&](const auto& pair) { return (pair.first == e.name && !e.given) || (pair.second == e.name && given(pair.first)); });
    }
};

Options::Options(std::string program, std::string purpose) : impl_(new Impl{std::move(program), std::move(purpose), {}, {}, {}}) {}
Options::~Options() = default;

void Options::number(const std::string& name, double& value, const std::string& unit, Range range, const std::string& help) {
    impl_->add({name, unit, help, Kind::number, &value, {}, range, {}});
}
void Options::integer(const std::string& name, int& value, const std::string& unit, Range range, const std::string& help) {
    impl_->add({name, unit, help, Kind::integer, &value, {}, range, {}});
}
void Options::integers(const std::string& name, std::vector<int>& value, const std::string& unit, Range range, const std::string& help) {
    impl_->add({name, unit, help, Kind::integers, &value, {}, range, {}});
}
void Options::choice(const std::string& name, std::string& value, const Words& allowed, const std::string& help) {
    impl_->add({name, "-", help, Kind::choice, &value, {}, {}, allowed});
}
void Options::text(const std::string& name, std::string& value, const std::string& help) {
    impl_->add({name, "-", help, Kind::text, &value, {}, {}, {}});
}
void Options::flag(const std::string& name, bool& value, const std::string& help) {
    impl_->add({name, "-", help, Kind::flag, &value, {}, {}, {}});
}
void Options::contradict(const std::string& a, const std::string& b) {
    impl_->contradictions.emplace_back(impl_->entry(a).name, impl_->entry(b).name);
}
void Options::unlabelled(const std::string& name) { impl_->entry(name).labelled = false; }

void Options::parse(int argc, const char* const* argv) {
    Words flags, asked;
    for (const Entry& e : impl_->entries)
        if (e.kind == Kind::flag) flags.push_back(e.name);

    struct Staged {
        Value value;
        bool in_command;
    };
    std::map<std::string, Staged> staged;
    for (const Setting& s : read_settings(argc, argv, impl_->names(), flags)) {
        if (holds(always, s.name)) {
            asked.push_back(s.name);
            continue;
        }
        const Entry& e = impl_->entry(s.name);
        auto value = read_value(e, s.raw);
        if (!value) throw BadInput(refusal(e, s.who, s.raw));
        staged[s.name] = {*std::move(value), s.who.compare(0, 2, "--") == 0};
    }
    for (const auto& [a, b] : impl_->contradictions) {
        if (staged.count(a) + staged.count(b) < 2) continue;
        if (staged[a].in_command == staged[b].in_command) throw BadInput("--" + a + " and --" + b + " cannot be given together");
        staged.erase(staged[a].in_command ? b : a);
    }

    for (Entry& e : impl_->entries) {
        e.given = staged.count(e.name) > 0;
        if (e.given) e.commit(staged[e.name].value);
    }
    impl_->asked = std::move(asked);
}

bool Options::asked(const std::string& name) const { return holds(impl_->asked, name); }
bool Options::given(const std::string& name) const { return holds(always, name) ? asked(name) : impl_->entry(name).given; }

std::string Options::label() const {
    Words items;
    bool lost = false;  // whether other settings may give the same letters
    for (const Entry& e : impl_->entries) {
        if (!e.changed()) continue;
        const std::string value = value_text(e.value());
        lost = lost || ((e.kind == Kind::text || e.kind == Kind::choice) && value != safe(value));
        items.push_back(e.name + "-" + safe(value));
    }
    if (items.empty()) return "default";
    std::string text = joined(items, "_");
    if (text.size() <= max_label && !lost) return text;
    text.resize(std::min(text.size(), max_label - 9));
    return text + "_" + short_hash(changed());
}

std::string Options::changed() const {
    Words items;
    for (const Entry& e : impl_->entries)
        if (e.changed()) items.push_back(e.name + "=" + quoted(value_text(e.value())));
    return joined(items, ";");
}

std::string Options::help() const {
    std::vector<std::pair<std::string, std::string>> lines;
    for (const Entry& e : impl_->entries) {
        const std::string unit = e.unit.empty() || e.unit == "-" ? "" : " [" + e.unit + "]";
        const std::string range = e.kind == Kind::text || e.kind == Kind::flag ? "" : "; " + allowed_text(e);
        const std::string standard = e.kind == Kind::flag ? "" : "; default " + one_line(quoted(value_text(e.standard)));
        std::string left = "--" + e.name;
        if (e.kind != Kind::flag) left.append(" ").append(kind_name(e.kind));
        lines.emplace_back(left, e.help + unit + range + standard);
    }
    lines.insert(lines.end(), {{"--config file", "read options from a file of name = value lines; the command line wins"},
                               {"--describe", "print the options as CSV and stop"},
                               {"--help", "print this help and stop"},
                               {"--version", "print the version and stop"}});
    std::size_t width = 0;
    for (const auto& line : lines) width = std::max(width, line.first.size());
    std::string text = impl_->program + ": " + impl_->purpose + "\nUsage: " + impl_->program + " [--name value | --name=value]...\n";
    for (const auto& [left, right] : lines) text += "  " + left + std::string(width - left.size() + 2, ' ') + one_line(right, 1000) + '\n';
    return text;
}

std::string Options::describe() const {
    std::string text = "name,type,default,unit,low,high,choices,help\n";
    for (const Entry& e : impl_->entries) {
        const auto bound = [](double x) { return std::isfinite(x) ? number_text(x) : std::string(); };
        const Words fields = {
            e.name, kind_name(e.kind), value_text(e.standard), e.unit, bound(e.range.low), bound(e.range.high), joined(e.allowed, "|"),
            e.help};
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (i > 0) text += ',';
            text += csv_field(fields[i]);
        }
        text += '\n';
    }
    return text;
}

std::string Options::ini() const {
    std::string text = "# " + one_line(impl_->program) + ": " + one_line(impl_->purpose, 1000) + "\n# Settings that --config reads.\n";
    for (const Entry& e : impl_->entries) {
        const bool idle = impl_->idle(e);  // written out, it would contradict the one in use
        if (idle) text += "# ";
        text += e.name + " = " + quoted(value_text(e.value())) + '\n';
    }
    return text;
}

}  // namespace mpm
