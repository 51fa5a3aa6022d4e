#include "lab/gnuplot.hpp"

#include <gnuplot-iostream.h>

#include <algorithm>
#include <cerrno>

#include "lab/record.hpp"

namespace mpm::detail {

std::string replaced(std::string_view text, const Replacements& pairs) {
    std::string result;
    while (!text.empty()) {
        const auto hit = std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return text.starts_with(pair.first); });
        result += hit != pairs.end() ? hit->second : text.substr(0, 1);
        text.remove_prefix(hit != pairs.end() ? hit->first.size() : 1);
    }
    return result;
}

std::string in_gnuplot(std::string_view text) { return std::string("'").append(replaced(text, {{"'", "''"}, {"\n", " "}})) + "'"; }

namespace {

/// The same words for LaTeX: those with indices, powers or symbols become formulas, unless the text is plain.
std::string latex(std::string_view text, bool plain) {
    static const Replacements escapes{{"%", "\\%"}, {"&", "\\&"}, {"#", "\\#"}, {"_", "\\_"}, {"^", "\\^{}"}};
    static const Replacements symbols{{"φ", "\\phi "},        {"∂", "\\partial "}, {"∇", "\\nabla "}, {"σ", "\\sigma "},
                                      {"ε", "\\varepsilon "}, {"α", "\\alpha "},   {"ρ", "\\rho "},   {"−", "-"},
                                      {"Σ", "\\Sigma "},      {"×", "\\times "}};
    std::string result;
    while (!text.empty()) {
        const std::size_t space = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, space);
        const bool formula = std::any_of(word.begin(), word.end(), [](char c) { return c == '_' || c == '^' || (c & 0x80) != 0; });
        result += formula && !plain ? std::string("$").append(replaced(word, symbols)).append("$") : replaced(word, escapes);
        text.remove_prefix(space);
        if (!text.empty()) result += ' ', text.remove_prefix(1);
    }
    return result;
}

}  // namespace

std::string label(const std::string& text, bool plain) {
    const std::string formulas = latex(text, plain);
    return formulas == text ? in_gnuplot(text) : "(tex ? " + in_gnuplot(formulas) + " : " + in_gnuplot(text) + ")";
}

std::string column(const std::string& name) { return "(column(" + in_gnuplot(name) + "))"; }

std::string write_script(const std::string& folder, const std::string& name, const std::function<void(std::ostream&)>& body) {
    const std::string path = folder + "/" + name + ".gp";
    replace_file(path, [&](const std::string& part) {
        errno = 0;
        try {  // gnuplot-iostream fills the temporary name
            Gnuplot gp(">" + part);
            body(gp);
            if (gp.flush()) return 0;
            if (errno == 0) gp.clear(), gp.flush();  // a part was taken, which is no error: the rest tells the reason
            return errno != 0 ? errno : EIO;  // before gp goes, which closes what has failed and says something else
        } catch (const std::ios_base::failure&) {  // the file could not be opened
            return errno != 0 ? errno : EIO;
        }
    });
    return path;
}

std::string script_start(const std::string& name) {
    return "# gnuplot " + name + ".gp draws " + name + ".png; other kinds: gnuplot -e \"kind='svg'\" " + name + ".gp\n" +
           "if (!exists(\"kind\")) kind = 'png'\ntex = kind eq 'tikz'\nset encoding utf8\nset datafile separator ','\n";
}

std::string script_terminal(const std::string& name, const std::string& width, const std::string& height) {
    const std::string pixels = width + "," + height, inches = "0.005*(" + width + "),0.005*(" + height + ")";
    return "if (kind eq 'png') set terminal pngcairo size " + pixels + " font ',18'\n" +
           "if (kind eq 'svg') set terminal svg size " + pixels + " dynamic font 'sans-serif,18' background rgb 'white'\n" + "if (kind eq 'pdf') set terminal pdfcairo size " + inches +
           " font ',9'\n" + "if (tex) set terminal cairolatex pdf size " + inches + "\n" + "set output " + in_gnuplot(name + ".") +
           ".(tex ? 'tex' : kind)\n";
}

/// From light to dark, so that it prints without colour; values of both signs get a scale that is grey at zero.
std::string colour_scale(const std::string& column, const std::string& text) {
    return "signs = c1 < 0 && c2 > 0 && -c1 > 0.02 * c2 && c2 > -0.02 * c1\n"
           "if (signs) { c2 = c2 > -c1 ? c2 : -c1; c1 = -c2 }\n"
           "if (!(c2 > c1)) c2 = c1 + (c1 == 0 ? 1 : 0.05 * abs(c1))\n"
           "if (signs) set palette defined (-1 '#08306b', -0.5 '#4292c6', 0 '#dedede', 0.5 '#ef6548', 1 '#7f0000')\n"
           "if (!signs) set palette defined (0 '#f9dc7a', 0.35 '#f1844b', 0.7 '#a8327d', 1 '#1c0f5e')\n"
           "set cbrange [c1 : c2]\nset format cb '%.4g'\nset cblabel " + label(text) + " offset 0.5,0\n" +
           (column == "body" || column == "material" ? "set cbtics 1\n" : "");
}

}  // namespace mpm::detail
