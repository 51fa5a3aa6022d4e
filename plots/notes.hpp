/// The chapters' notes (chapters/*/notes.md) as HTML.
#pragma once
#include <string>

namespace mpm {

/// What notes are written in of Markdown: headings, paragraphs, lists with "-", tables, `code` and **bold**. Headings begin at <h3>; they,
/// paragraphs and cells are one line or several until an empty line or another kind of line.
std::string notes_html(const std::string& markdown);

}  // namespace mpm
