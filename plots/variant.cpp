#include "plots/variant.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "lab/options.hpp"
#include "lab/record.hpp"
#include "plots/process.hpp"

namespace mpm {
namespace {

namespace fs = std::filesystem;
constexpr double patience = 30;  // seconds for a program to describe itself
constexpr std::size_t longest_name = 52;

Words lines(const std::string& text) {
    Words all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) all.push_back(line);
    return all;
}

bool holds(const Words& words, const std::string& word) { return std::find(words.begin(), words.end(), word) != words.end(); }

std::string hint(const std::string& word, const Words& known, const std::string& dashes) {
    const std::string near = nearest(word, known);
    return near.empty() ? "" : " (did you mean " + dashes + near + "?)";
}

/// Two files for what a program prints, gone when this goes.
struct Scratch {
    std::string path;
    Scratch() {
        path = (fs::temp_directory_path() / "mpm_XXXXXX").string();
        if (mkdtemp(path.data()) == nullptr) throw FileTrouble("cannot make a folder like " + path);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    std::string output() const { return path + "/output"; }
    std::string errors() const { return path + "/errors"; }
};

}  // namespace

std::string joined(const Words& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) {
        if (&word != &words.front()) text += between;
        text += word;
    }
    return text;
}

std::string file_safe(const std::string& text, std::size_t limit) {
    std::string safe = text;
    for (char& c : safe)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string("._+-").find(c) == std::string::npos) c = '-';
    if (safe == text && safe.size() <= limit) return safe;
    std::uint32_t hash = 2166136261u;  // FNV-1a
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08lx", static_cast<unsigned long>(hash));
    return safe.substr(0, limit - 9) + "_" + digits;
}

std::string written(const std::string& folder, const Words& files) {
    std::string text = "written to " + folder + ":";
    for (const std::string& file : files) text += " " + (file.starts_with(folder + "/") ? file.substr(folder.size() + 1) : file);
    return text + "\n";
}

std::string Variant::options() const {
    Words items;
    for (const auto& [name, value] : settings) items.push_back(name + "=" + value);
    return joined(items, ";");
}

std::string Variant::file_name() const {
    std::string text = program;
    for (const auto& [name, value] : settings) text += "_" + name + "-" + value;
    return file_safe(text);
}

std::string Variant::value(const std::string& name) const {
    for (const auto& [known, value] : settings)
        if (known == name) return value;
    const auto standard = defaults.find(name);
    return standard == defaults.end() ? "" : standard->second;
}

std::pair<Words, std::vector<Words>> split_variants(int argc, const char* const* argv) {
    std::pair<Words, std::vector<Words>> parts;
    for (int i = 0; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--")
            parts.second.emplace_back();
        else
            (parts.second.empty() ? parts.first : parts.second.back()).push_back(word);
    }
    return parts;
}

Words short_names(const std::vector<Variant>& variants, std::string& shared) {
    const auto common = [&](const auto& setting) {
        return std::all_of(variants.begin(), variants.end(), [&](const Variant& v) { return v.value(setting.first) == setting.second; });
    };
    const bool several = variants.size() > 1,
               one_program = several && std::all_of(variants.begin(), variants.end(), [&](const Variant&v) {
                                 return v.program == variants.front().program && !std::all_of(v.settings.begin(), v.settings.end(), common);
                             });
    const Words plain{"scheme", "shape", "transfer", "law", "case", "points"};  // whose values speak for themselves
    Words names, cut, same;
    if (one_program) same.push_back(variants.front().program);
    for (const Variant& v : variants) {
        Words name;
        if (!one_program) name.push_back(v.program);
        for (const auto& [option, value] : v.settings) {
            const std::string text = option + " = " + value;
            if (!several || !common(std::pair(option, value)))
                name.push_back(holds(plain, option) ? value : text);
            else if (!holds(same, text))
                same.push_back(text);
        }
        if (name.empty()) name.push_back(v.program);
        cut.push_back(one_line(joined(name, ", "), longest_name));
        const auto twins = std::count(cut.begin(), cut.end(), cut.back());
        names.push_back(cut.back() + (twins > 1 ? " (" + std::to_string(twins) + ")" : ""));
    }
    shared = joined(same, ", ");
    return names;
}

Programs::Programs(const std::string& folder) {
    std::error_code error;
    folder_ =
        (folder.empty() ? fs::canonical("/proc/self/exe", error).parent_path() : fs::absolute(folder, error).lexically_normal()).string();
    names_ = lines(read_file(folder_ + "/programs.txt"));
}

std::string Programs::path(const std::string& name) const {
    if (!holds(names_, name)) throw BadInput("unknown program " + one_line(name) + hint(name, names_, ""));
    const std::string path = folder_ + "/" + name;
    if (!fs::exists(path)) throw BadInput("program " + name + " is not built: there is no " + path);
    return path;
}

const CsvTable& Programs::describe(const std::string& name) {
    const auto known = described_.find(name);
    if (known != described_.end()) return known->second;
    const Scratch scratch;
    const Ending end = run_process({path(name), {"--describe"}}, scratch.output(), scratch.errors(), patience);
    if (end.stopped) throw FileTrouble("interrupted");
    if (end.code != 0 || !end.usable()) throw FileTrouble(name + " --describe ended with " + (end.usable() ? "exit 3" : end.trouble()));
    CsvTable table = parse_csv(read_file(scratch.output()), name + " --describe");
    for (const char* column : {"name", "type", "default"})
        if (!table.has(column)) throw FileTrouble(name + " --describe has no column " + column);
    return described_[name] = std::move(table);
}

bool Programs::accepts(const std::string& name, const std::string& option) {
    const CsvTable& options = describe(name);
    for (std::size_t i = 0; i < options.rows.size(); ++i)
        if (options.text(i, "name") == option) return true;
    return false;
}

Variant Programs::variant(const Words& words, const Words& managed) {
    if (words.empty()) throw BadInput("a program is missing after --");
    Variant v{words.front(), {words.begin() + 1, words.end()}, {}};
    const CsvTable& options = describe(v.program);
    std::map<std::string, bool> takes_value{{"config", true}};
    for (std::size_t i = 0; i < options.rows.size(); ++i) {
        takes_value[options.text(i, "name")] = options.text(i, "type") != "flag";
        v.defaults[options.text(i, "name")] = options.text(i, "default");
    }
    Words known;
    for (const auto& option : takes_value) known.push_back(option.first);
    for (std::size_t i = 0; i < v.words.size(); ++i) {
        const std::string& word = v.words[i];
        if (!word.starts_with("--"))
            throw BadInput(v.program + ": unexpected word '" + one_line(word) + "': options are given as --name value");
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(2, equals == std::string::npos ? equals : equals - 2);
        if (holds(managed, name))
            throw BadInput(v.program + ": --" + name + " is set for every variant, before the first --, or by this program itself");
        if (!takes_value.contains(name)) throw BadInput(v.program + ": unknown option --" + one_line(name) + hint(name, known, "--"));
        std::string value = "true";
        if (equals != std::string::npos) {
            value = word.substr(equals + 1);
        } else if (takes_value[name]) {
            if (i + 1 == v.words.size() || v.words[i + 1].starts_with("--")) throw BadInput(v.program + ": --" + name + " needs a value");
            value = v.words[++i];
        }
        v.settings.emplace_back(name, value);
    }
    return v;
}

void Programs::check_values(const Variant& variant, const Words& more) {
    if (!accepts(variant.program, "dry-run")) return;
    const Scratch scratch;
    Command command{path(variant.program), variant.words};
    command.words.insert(command.words.end(), more.begin(), more.end());
    command.words.push_back("--dry-run");
    const Ending end = run_process(command, scratch.output(), scratch.errors(), patience);
    const Words said = lines(read_file(scratch.errors()));
    if (end.signal == 0 && end.code == 2) throw BadInput(said.empty() ? shell_text(command) + " is refused" : said.front());
}

}  // namespace mpm
