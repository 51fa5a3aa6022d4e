/// Pieces of HTML.
#pragma once
#include <string>

namespace mpm {

/// Text with the characters that HTML would read escaped.
inline std::string html(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else
            safe += c;
    }
    return safe;
}
/// A cell of a table, of a class of the page's style.
inline std::string html_cell(const std::string& text, const std::string& kind = "number") {
    return "<td class=\"" + kind + "\">" + html(text) + "</td>";
}

/// Writes a page around `body`. Throws FileTrouble.
void write_page(const std::string& path, const std::string& title, const std::string& body);

}  // namespace mpm
