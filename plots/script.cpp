#include "plots/script.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "lab/record.hpp"

namespace mpm {
namespace {

/// A number on an axis: plain within a thousandth and a thousand if all are, else a power of ten.
std::string tic(int factor, int decade, bool powers) {
    const double value = factor * std::pow(10, decade);
    char text[64], latex[64];
    if (!powers) {
        std::snprintf(text, sizeof text, "%g", value);
        return gnuplot_text(text);
    }
    const std::string times = factor == 1 ? "" : std::to_string(factor);
    std::snprintf(text, sizeof text, "%s10^{%d}", factor == 1 ? "" : (times + "·").c_str(), decade);
    std::snprintf(latex, sizeof latex, "$%s10^{%d}$", factor == 1 ? "" : (times + "\\cdot ").c_str(), decade);
    return formula(text, latex);
}

constexpr std::size_t letters_of_half = 34;  // that half the width of a figure takes

std::string range(char axis, double low, double high) {
    return std::string("set logscale ") + axis + "\nset " + axis + "range [" + number_text(low) + ":" + number_text(high) + "]\n";
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "''" : c == '\n' ? " " : std::string(1, c);
    return quoted + "'";
}

std::string formula(const std::string& text, const std::string& latex) {
    return text == latex ? gnuplot_text(text) : "(tex ? " + gnuplot_text(latex) + " : " + gnuplot_text(text) + ")";
}

std::string plain(const std::string& text) {
    std::string enhanced, latex;
    for (const char c : text) {
        if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) enhanced += '\\';  // gnuplot's own marks
        if (std::string_view("_^{}&%#$").find(c) != std::string_view::npos) latex += '\\';
        enhanced += c;
        latex += c;
        if (c == '^') latex += "{}";
    }
    return formula(enhanced, latex);
}

std::string script_head(const std::string& name, int width, int height, const std::string& title) {
    const auto size = [&](double unit) { return number_text(width * unit) + "," + number_text(height * unit); };
    return "# gnuplot " + name + ".gp draws " + name + ".png; other kinds: gnuplot -e \"kind='svg'\" " + name + ".gp\n" +
           "if (!exists(\"kind\")) kind = 'png'\ntex = kind eq 'tikz'\nset encoding utf8\n" +
           "if (kind eq 'png') set terminal pngcairo size " + size(1) + " font ',18'\n" + "if (kind eq 'svg') set terminal svg size " +
           size(1) + " dynamic font 'sans-serif,18' background rgb 'white'\n" + "if (kind eq 'pdf') set terminal pdfcairo size " +
           size(0.005) + " font ',9'\n" + "if (tex) set terminal cairolatex pdf size " + size(0.005) + "\n" + "set output " +
           gnuplot_text(name + ".") + ".(tex ? 'tex' : kind)\n" +
           "set datafile separator ','\nset datafile missing 'nan'\nset grid lc rgb '#dddddd' lt 1 lw 1\nset title " + plain(title) + "\n";
}

std::string curve_style(std::size_t n, bool thin) {
    static constexpr std::array<const char*, 6> colours{"#000000", "#d55e00", "#0072b2", "#e69f00", "#009e73", "#cc79a7"};
    static constexpr std::array<const char*, 5> dashes{"solid", "(20,8)", "(4,6)", "(36,8)", "(20,7,4,7)"};
    static constexpr std::array<int, 7> markers{7, 4, 9, 12, 5, 6, 11};  // filled and open by turns
    return std::string(thin ? "lw 1.2" : "lw 2.5") + " dt " + dashes[n % dashes.size()] + " pt " +
           std::to_string(markers[n % markers.size()]) + (thin ? " ps 1.2" : " ps 1.7") + " lc rgb '" + colours[n % colours.size()] + "'";
}

int legend_height(std::size_t entries) { return 28 * static_cast<int>(entries) + 30; }

std::string legend_of(const std::vector<std::string>& names, std::size_t& lines) {
    const bool two =
        names.size() > 6 && std::all_of(names.begin(), names.end(), [](const auto& name) { return name.size() <= letters_of_half; });
    lines = two ? (names.size() + 1) / 2 : names.size();
    return "set key below left Left reverse vertical height 0.6 samplen 3 maxrows " + std::to_string(lines) + "\n";
}

std::string log_axis(char axis, double low, double high) {
    const double first = low / 1.35, last = high * 1.35;
    const bool short_range = last / first < 300, powers = first < 1e-3 || last > 1e4;
    std::string tics;
    const int lowest = static_cast<int>(std::floor(std::log10(first))), highest = static_cast<int>(std::ceil(std::log10(last)));
    const int stride = std::max(1, (highest - lowest) / 8);
    for (int decade = lowest; decade <= highest; ++decade) {
        for (const int factor : {1, 2, 5}) {
            const double value = factor * std::pow(10, decade);
            if (value < first || value > last || (factor != 1 && !short_range) || (decade - lowest) % stride != 0) continue;
            tics += (tics.empty() ? "" : ", ") + tic(factor, decade, powers) + " " + number_text(value);
        }
    }
    return range(axis, first, last) + "set " + axis + "tics (" + tics + ")\n";
}

std::string log_axis(char axis, const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    std::string tics;
    char text[32];
    for (const double value : values) {
        std::snprintf(text, sizeof text, "'%.4g' ", value);
        tics += (tics.empty() ? "" : ", ") + (text + number_text(value));
    }
    return range(axis, *low / 1.2, *high * 1.2) + "set " + axis + "tics (" + tics + ")\n";
}

}  // namespace mpm
