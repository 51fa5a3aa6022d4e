#include "plots/html.hpp"

#include "lab/record.hpp"

namespace mpm {
namespace {

constexpr const char* style = R"(
body { font: 17px/1.45 Georgia, serif; max-width: 62em; margin: 2em auto; padding: 0 1em; color: #111; background: #fff; }
h1, h2 { font-weight: normal; }
a { text-underline-offset: .25em; }
nav a { margin-right: 1.2em; }
figure { margin: 2em 0; break-inside: avoid; }
img { max-width: 100%; height: auto; }
img.large { max-width: 59%; vertical-align: top; }
img.small { max-width: 39%; vertical-align: top; }
code { overflow-wrap: anywhere; font-size: 85%; }
.command { font-size: 12px; line-height: 1.2; margin: .3em 0; }
.overview { font-family: Georgia, serif; font-size: 14px; }
.class { padding-top: .8em; font-style: italic; }
section table { font-family: Georgia, serif; font-size: 14px; width: auto; }
figcaption { margin: .4em 0; }
table { border-collapse: collapse; font: 13px/1.35 monospace; width: 100%; }
th, td { border-bottom: 1px solid #ccc; padding: .1em .5em; text-align: left; vertical-align: top; overflow-wrap: anywhere; }
.number { text-align: right; white-space: nowrap; }
.bad { color: #b03000; }
@media print {
  body { font-size: 11pt; max-width: none; margin: 0; }
  nav { display: none; }
  tr { break-inside: avoid; }
  .overview { font-size: 8.5pt; }
  h2 { break-before: page; }
  a { color: inherit; }
}
)";

}  // namespace

void write_page(const std::string& path, const std::string& title, const std::string& body) {
    write_file(path, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + html(title) + "</title>\n<style>" +
                         style + "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n");
}

}  // namespace mpm
