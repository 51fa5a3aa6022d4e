#include "lab/options.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "lab/record.hpp"

namespace mpm {

namespace {

namespace po = boost::program_options;
using Words = std::vector<std::string>;
using Value = std::variant<double, int, std::vector<int>, std::string, bool>;
using Target = std::variant<double*, int*, std::vector<int>*, std::string*, bool*>;
enum class Kind { number, integer, integers, choice, text, flag };

const Words kind_names = {"number", "integer", "integers", "choice", "text", "flag"};
const Words always = {"help", "version", "describe", "config"};
constexpr std::size_t max_items = 1000, max_bytes = 1'000'000, max_label = 80;

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

std::string joined(const Words& words, const std::string& between) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) text += (i > 0 ? between : "") + words[i];
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

/// Quotes a text that a config file or a list of settings would otherwise read differently.
std::string quoted(const std::string& text) {
    const bool plain = text.find_first_of("#;\"") == std::string::npos;
    if (plain && !text.empty() && text.front() != ' ' && text.back() != ' ') return text;
    std::string result = "\"";
    for (const char c : text) result += (c == '"' || c == '\\') ? std::string("\\") + c : std::string(1, c);
    return result + '"';
}

bool has_control(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
}

/// The whole of a text as a number, with an optional leading plus.
template <class Number> std::optional<Number> read_number(const std::string& text) {
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

/// What an option takes, for messages and help.
std::string allowed_text(const Entry& e) {
    const bool bounded = e.range.text() != Range{}.text();
    switch (e.kind) {
        case Kind::number: return e.range.text();
        case Kind::integer: return bounded ? "whole numbers " + e.range.text() : "any whole number";
        case Kind::integers: return "1 to 1000 whole numbers" + (bounded ? " " + e.range.text() : "") + " with commas between";
        case Kind::choice: return joined(e.allowed, ", ");
        case Kind::flag: return "true, false, on, off, 1, 0";
        case Kind::text: break;
    }
    return "text without control characters";
}

/// Reads one value, or nothing if it is not allowed.
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

/// The message for a value that is not allowed: `who` is the option as the user wrote it.
std::string refusal(const Entry& e, const std::string& who, const std::string& raw) {
    std::string text = who + " = " + one_line(raw) + ": allowed " + allowed_text(e);
    const std::string near = e.kind == Kind::choice ? nearest(raw, e.allowed) : "";
    if (!near.empty()) text += " (did you mean " + near + "?)";
    return text + ", default " + one_line(quoted(value_text(e.standard)));
}

/// One setting as the user wrote it; `who` names it in messages ("--nu", "case.ini:3: nu").
struct Setting {
    std::string name, who, raw;
};

[[noreturn]] void refuse_unknown(const std::string& before, const std::string& dashes, const std::string& name, const Words& known) {
    const std::string near = nearest(name, known), hint = dashes.empty() ? "" : "--";
    throw BadInput(before + "unknown option " + dashes + one_line(name) +
                   (near.empty() ? " (--help lists them)" : " (did you mean " + hint + near + "?)"));
}

/// Runs Boost's command line parser; its complaints become BadInput.
po::parsed_options split(const Words& words, const po::options_description& known) {
    using Style = po::command_line_style::style_t;
    const int style = Style::allow_long | Style::long_allow_adjacent | Style::long_allow_next;  // no abbreviations
    try {
        return po::command_line_parser(words).options(known).style(style).allow_unregistered().run();
    } catch (const po::invalid_command_line_syntax& e) {
        const bool extra = e.kind() == po::invalid_syntax::extra_parameter;
        throw BadInput(one_line(e.get_option_name()) + (extra ? " takes no value" : " needs a value"));
    } catch (const po::error& e) {
        throw BadInput("command line: " + one_line(e.what(), 200));
    }
}

/// The words after the program's name. "--out=" becomes "--out" "", for Boost refuses an empty value after "=".
Words command_words(int argc, const char* const* argv, const po::options_description& known) {
    Words words;
    for (int i = 1; i < argc; ++i) {
        std::string word = argv[i];
        const bool open = word.size() > 3 && word.compare(0, 2, "--") == 0 && word.find('=') == word.size() - 1;
        if (open) word.pop_back();
        const auto* option = open ? known.find_nothrow(word.substr(2), false) : nullptr;
        if (option != nullptr && option->semantic()->max_tokens() == 0) throw BadInput(word + " takes no value");
        words.push_back(std::move(word));
        if (open) words.emplace_back();
    }
    return words;
}

std::vector<Setting> read_command(int argc, const char* const* argv, const po::options_description& known, const Words& names) {
    std::vector<Setting> settings;
    for (const auto& option : split(command_words(argc, argv, known), known).options) {
        const std::string& name = option.string_key;
        if (name.empty()) {
            const std::string word = option.original_tokens.empty() ? "" : option.original_tokens.front();
            if (word.size() > 1 && word[0] == '-' && word[1] != '-') refuse_unknown("", "-", word.substr(1), names);
            throw BadInput("unexpected word '" + one_line(word) + "': options are given as --name value");
        }
        if (option.unregistered) refuse_unknown("", "--", name, names);
        const bool next = option.original_tokens.size() > 1;
        if (next && option.value.front().compare(0, 2, "--") == 0) throw BadInput("--" + name + " needs a value");
        for (const Setting& earlier : settings)
            if (earlier.name == name) throw BadInput("--" + name + " is given twice");
        settings.push_back({name, "--" + name, option.value.empty() ? "true" : option.value.front()});
    }
    return settings;
}

/// The text of a config file, which must be small and hold no control characters.
std::string read_text(const std::string& path) {
    const std::string where = "cannot read config file '" + one_line(path, 300) + "': ";
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) throw FileTrouble(where + "it is a directory");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) throw FileTrouble(where + std::strerror(errno));
    std::string text(max_bytes + 1, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file.get()));
    if (std::ferror(file.get()) != 0) throw FileTrouble(where + std::strerror(errno));
    if (text.size() > max_bytes) throw FileTrouble(where + "it is larger than 1 MB");
    const auto binary = [](unsigned char c) { return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F; };
    if (std::any_of(text.begin(), text.end(), binary)) throw FileTrouble(where + "it is not a text file");
    return text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? text.substr(3) : text;  // without a byte order mark
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// What stands right of "=": up to a comment, or between quotes.
std::string config_value(const std::string& text, const std::string& where) {
    if (text.empty() || text.front() != '"') return trimmed(text.substr(0, text.find('#')));
    std::string value;
    std::size_t i = 1;
    for (; i < text.size() && text[i] != '"'; ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        value += text[i];
    }
    if (i >= text.size()) throw BadInput(where + "a quote is not closed in " + one_line(text));
    const std::string rest = trimmed(text.substr(i + 1));
    if (!rest.empty() && rest.front() != '#') throw BadInput(where + "unexpected text after the quote: " + one_line(rest));
    return value;
}

std::vector<Setting> read_config(const std::string& path, const Words& names) {
    const std::string text = read_text(path);
    std::vector<Setting> settings;
    std::map<std::string, int> seen;  // line of each name
    int number = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string line = trimmed(text.substr(from, end - from));
        const std::string where = one_line(path, 300) + ":" + std::to_string(++number) + ": ";
        from = end + 1;
        if (line.empty() || line.front() == '#') continue;
        const std::size_t equals = line.find('=');
        if (equals == std::string::npos) throw BadInput(where + "expected name = value, found " + one_line(line));
        const std::string name = trimmed(line.substr(0, equals));
        if (std::find(always.begin(), always.end(), name) != always.end()) throw BadInput(where + name + " belongs on the command line");
        if (std::find(names.begin(), names.end(), name) == names.end()) refuse_unknown(where, "", name, names);
        const auto [earlier, fresh] = seen.emplace(name, number);
        if (!fresh) throw BadInput(where + name + " is given twice, first in line " + std::to_string(earlier->second));
        settings.push_back({name, where + name, config_value(trimmed(line.substr(equals + 1)), where)});
    }
    return settings;
}

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

bool Range::contains(double x) const {
    return std::isfinite(x) && (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
}

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
std::string nearest(const std::string& word, const Words& known) {
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
        if (odd || std::count(taken.begin(), taken.end(), e.name) + std::count(always.begin(), always.end(), e.name) > 0)
            throw std::logic_error("option name cannot be used: " + e.name);
        if (read_value(e, value_text(e.standard)) != e.standard) throw std::logic_error("default of option " + e.name + " is not allowed");
        entries.push_back(std::move(e));
    }
    bool contradicted(const std::string& name) const {
        const auto names_it = [&](const auto& pair) { return pair.first == name || pair.second == name; };
        return std::any_of(contradictions.begin(), contradictions.end(), names_it);
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
    po::options_description known;
    for (const Entry& e : impl_->entries) {
        if (e.kind == Kind::flag) known.add_options()(e.name.c_str(), "");
        else known.add_options()(e.name.c_str(), po::value<std::string>(), "");
    }
    known.add_options()("help", "")("version", "")("describe", "")("config", po::value<std::string>(), "");
    const Words own = impl_->names();
    Words all = own, asked;
    all.insert(all.end(), always.begin(), always.end());

    std::vector<Setting> settings;
    const auto command = read_command(argc, argv, known, all);
    for (const Setting& s : command)
        if (s.name == "config") settings = read_config(s.raw, own);
    settings.insert(settings.end(), command.begin(), command.end());

    std::map<std::string, Value> staged;
    for (const Setting& s : settings) {
        if (std::find(always.begin(), always.end(), s.name) != always.end()) {
            asked.push_back(s.name);
            continue;
        }
        const Entry& e = impl_->entry(s.name);
        auto value = read_value(e, s.raw);
        if (!value) throw BadInput(refusal(e, s.who, s.raw));
        staged[s.name] = *std::move(value);
    }
    for (const auto& [a, b] : impl_->contradictions)
        if (staged.count(a) + staged.count(b) == 2) throw BadInput("--" + a + " and --" + b + " cannot be given together");

    for (Entry& e : impl_->entries) {
        e.given = staged.count(e.name) > 0;
        if (e.given) e.commit(staged[e.name]);
    }
    impl_->asked = std::move(asked);
}

bool Options::asked(const std::string& name) const {
    return std::find(impl_->asked.begin(), impl_->asked.end(), name) != impl_->asked.end();
}
bool Options::given(const std::string& name) const {
    return std::find(always.begin(), always.end(), name) != always.end() ? asked(name) : impl_->entry(name).given;
}

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
        const std::string takes = e.kind == Kind::flag ? "" : " " + kind_names[static_cast<std::size_t>(e.kind)];
        lines.emplace_back("--" + e.name + takes, e.help + unit + range + standard);
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
        const Words fields = {e.name, kind_names[static_cast<std::size_t>(e.kind)], value_text(e.standard), e.unit, bound(e.range.low),
                              bound(e.range.high), joined(e.allowed, "|"), e.help};
        for (std::size_t i = 0; i < fields.size(); ++i) text += (i > 0 ? "," : "") + csv_field(fields[i]);
        text += '\n';
    }
    return text;
}

std::string Options::ini() const {
    std::string text = "# " + one_line(impl_->program) + ": " + one_line(impl_->purpose, 1000) + "\n# Settings that --config reads.\n";
    for (const Entry& e : impl_->entries) {
        const bool idle = !e.given && impl_->contradicted(e.name);  // written out, it would contradict the one in use
        text += (idle ? "# " : "") + e.name + " = " + quoted(value_text(e.value())) + '\n';
    }
    return text;
}

}  // namespace mpm
