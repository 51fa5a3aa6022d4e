#include "plots/case_table.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "lab/options.hpp"

namespace mpm {
namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}
Words split(const std::string& text, char between) {
    Words parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, between);) parts.push_back(trimmed(part));
    return parts;
}
Words words_of(const std::string& text) {
    Words words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

/// One line of the file: its first word and its fields.
struct Line {
    std::string where, keyword;
    Words fields;

    const std::string& field(std::size_t i) const {
        if (i >= fields.size()) throw BadInput(where + ": " + keyword + " needs a field " + std::to_string(i + 1));
        return fields[i];
    }
    double number(std::size_t i) const {
        char* end = nullptr;
        const double value = std::strtod(field(i).c_str(), &end);
        if (end == field(i).c_str() || *end != '\0') throw BadInput(where + ": '" + field(i) + "' is no number");
        return value;
    }
};

ExtremeCase case_of(const Line& line, const CaseTable& table) {
    ExtremeCase row;
    row.group = line.field(0), row.value = line.field(1), row.scene = line.field(2), row.words = words_of(line.field(3));
    if (!table.scenes.contains(row.scene)) throw BadInput(line.where + ": there is no scene " + row.scene + " above");
    if (line.keyword == "limit") row.kind = ExtremeCase::Kind::limit;
    if (line.keyword == "step") row.kind = ExtremeCase::Kind::step;
    if (row.kind != ExtremeCase::Kind::limit) {
        row.error = line.field(4), row.bound = line.number(5), row.why = line.field(6);
        if (row.why.empty()) throw BadInput(line.where + ": a bound needs its reason");
    }
    if (row.kind == ExtremeCase::Kind::step) row.part = line.number(7);
    row.quick = !(row.kind == ExtremeCase::Kind::run && line.fields.size() > 7 && line.field(7) == "full");
    return row;
}

void add_scene(const Line& line, CaseTable& table) {
    for (const std::string& column : split(line.field(1), ',')) {
        const bool known = column == "*" || std::any_of(table.columns.begin(), table.columns.end(),
                                                        [&](const CaseColumn& c) { return c.name == column; });
        if (!known) throw BadInput(line.where + ": there is no column " + column + " above");
        table.scenes[line.field(0)][column] = line.field(2);
    }
}

std::string place(const std::string& group, const std::string& value, const std::string& column) {
    return group + "|" + value + "|" + column;
}

}  // namespace

std::string CaseTable::known(const ExtremeCase& row, const CaseColumn& column) const {
    for (const std::string& value : {row.value, std::string("*")})
        if (const auto at = causes.find(place(row.group, value, column.name)); at != causes.end()) return at->second;
    return "";
}

Words CaseTable::command(const ExtremeCase& row, const CaseColumn& column, std::string& why_not) const {
    const auto& scene = scenes.at(row.scene);
    auto at = scene.find(column.name);
    if (at == scene.end()) at = scene.find("*");
    if (at == scene.end()) return why_not = "the table does not say how", Words{};
    if (at->second.starts_with("none:")) return why_not = trimmed(at->second.substr(5)), Words{};
    Words words = words_of(at->second);
    words.insert(words.end(), column.words.begin(), column.words.end());
    words.insert(words.end(), row.words.begin(), row.words.end());
    return words;
}

std::vector<CaseTable> read_case_tables(const std::string& text, const std::string& name) {
    std::vector<CaseTable> tables;
    std::istringstream stream(text);
    int number = 0;
    for (std::string raw; std::getline(stream, raw);) {
        ++number;
        const std::string whole = trimmed(raw.substr(0, raw.find('#')));
        if (whole.empty()) continue;
        const std::size_t space = std::min(whole.find(' '), whole.size());
        const Line line{name + ", line " + std::to_string(number), whole.substr(0, space), split(whole.substr(space), '|')};
        if (line.keyword == "table") {
            line.field(1);
            const std::string rest = whole.substr(space);
            tables.push_back({line.field(0), trimmed(rest.substr(rest.find('|') + 1)), {}, {}, {}, {}});  // a title may have | in it
            continue;
        }
        if (tables.empty()) throw BadInput(line.where + ": a table must begin first");
        CaseTable& table = tables.back();
        if (line.keyword == "column")
            table.columns.push_back({line.field(0), line.fields.size() > 1 && !line.field(1).empty() ? line.field(1) : line.field(0),
                                     line.fields.size() > 2 ? words_of(line.field(2)) : Words{}});
        else if (line.keyword == "scene")
            add_scene(line, table);
        else if (line.keyword == "known")
            for (const std::string& column : split(line.field(2), ','))
                table.causes[place(line.field(0), line.field(1), column)] = line.field(3);
        else if (line.keyword == "case" || line.keyword == "limit" || line.keyword == "step")
            table.cases.push_back(case_of(line, table));
        else
            throw BadInput(line.where + ": unknown word " + line.keyword + ", allowed: table, column, scene, case, limit, step, known");
    }
    return tables;
}

}  // namespace mpm
