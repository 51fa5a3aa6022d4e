#include "lab/options_read.hpp"

#include <algorithm>
#include <boost/program_options.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "lab/options.hpp"
#include "lab/record.hpp"

namespace mpm::detail {
namespace {

namespace po = boost::program_options;
using Words = std::vector<std::string>;
constexpr std::size_t max_bytes = 1'000'000;

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

}  // namespace

std::vector<Setting> read_settings(int argc, const char* const* argv, const Words& names, const Words& flags) {
    po::options_description known;
    for (const std::string& name : names) {
        if (std::find(flags.begin(), flags.end(), name) != flags.end())
            known.add_options()(name.c_str(), "");
        else
            known.add_options()(name.c_str(), po::value<std::string>(), "");
    }
    known.add_options()("help", "")("version", "")("describe", "")("config", po::value<std::string>(), "");
    Words all = names;
    all.insert(all.end(), always.begin(), always.end());

    std::vector<Setting> settings;
    const auto command = read_command(argc, argv, known, all);
    for (const Setting& s : command)
        if (s.name == "config") settings = read_config(s.raw, names);
    settings.insert(settings.end(), command.begin(), command.end());
    return settings;
}

}  // namespace mpm::detail
