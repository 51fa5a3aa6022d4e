#include "plots/notes.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "plots/html.hpp"

namespace mpm {
namespace {

/// `code` and **bold** within a line; a mark without its partner stays as it is.
std::string spans(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const bool code = text[at] == '`', bold = text.compare(at, 2, "**") == 0;
        const std::string mark = code ? "`" : "**", tag = code ? "code" : "b";
        const std::size_t from = at + mark.size(), end = code || bold ? text.find(mark, from) : std::string::npos;
        if (end == std::string::npos) {
            out += html(text.substr(at++, 1));
            continue;
        }
        const std::string inside = text.substr(from, end - from);
        out += "<" + tag + ">" + (code ? html(inside) : spans(inside)) + "</" + tag + ">";
        at = end + mark.size();
    }
    return out;
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream parts(line.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) {
        const std::size_t from = std::min(cell.find_first_not_of(' '), cell.size());
        cells.push_back(cell.substr(from, cell.find_last_not_of(' ') + 1 - from));
    }
    return cells;
}

bool is_rule(const std::string& line) { return line.find_first_not_of("|-: ") == std::string::npos; }

/// Reads line by line, and closes what is open when another kind of block begins.
class Notes {
public:
    void line(const std::string& text) {
        const std::size_t from = text.find_first_not_of(' ');
        if (from == std::string::npos) return close();
        if (text[0] == '#') return heading(text);
        if (text[from] == '|') return table_row(text.substr(from));
        if (text.compare(0, 2, "- ") == 0) return item(text.substr(2));
        if (open_ == "table") close();
        if (open_.empty()) begin("p");
        words_ += (words_.empty() ? "" : " ") + text.substr(from);
    }
    std::string page() {
        close();
        return page_;
    }

private:
    void begin(const std::string& tag) {
        close();
        open_ = tag;
        page_ += "<" + tag + ">";
    }
    void close() {
        flush();
        if (!open_.empty()) page_ += (open_ == "ul" ? "</li></" : "</") + open_ + ">\n";
        open_.clear();
    }
    void flush() {
        page_ += spans(words_);
        words_.clear();
    }
    void heading(const std::string& text) {
        close();
        const std::size_t level = std::min(text.find_first_not_of('#'), text.size());
        const std::string tag = level == 1 ? "h3" : "h4";
        page_ += "<" + tag + ">" + spans(text.substr(std::min(level + 1, text.size()))) + "</" + tag + ">\n";
    }
    void item(const std::string& text) {
        if (open_ == "ul")
            flush(), page_ += "</li>\n";
        else
            begin("ul");
        page_ += "<li>";
        words_ = text;
    }
    void table_row(const std::string& text) {
        if (is_rule(text)) return;
        const bool head = open_ != "table";
        if (head) begin("table");
        page_ += "<tr>";
        for (const std::string& cell : cells_of(text)) page_ += (head ? "<th>" : "<td>") + spans(cell) + (head ? "</th>" : "</td>");
        page_ += "</tr>\n";
    }

    std::string page_, open_, words_;
};

}  // namespace

std::string notes_html(const std::string& markdown) {
    Notes notes;
    std::istringstream lines(markdown);
    for (std::string line; std::getline(lines, line);) notes.line(line);
    return notes.page();
}

}  // namespace mpm
