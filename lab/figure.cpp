#include "lab/figure.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "lab/record.hpp"

namespace mpm {

std::string write_figure(const std::string& folder, const std::string& name, const std::string& csv, const std::string& title,
                         const std::vector<Panel>& panels) {
    std::ostringstream s;
    s << "# gnuplot " << name << ".gp draws " << name << ".png; other kinds: gnuplot -e \"kind='svg'\" " << name << ".gp\n"
      << "if (!exists(\"kind\")) kind = 'png'\n"
      << "if (kind eq 'png') set terminal pngcairo size 1200," << 480 * panels.size() << " font ',16'\n"
      << "if (kind eq 'svg') set terminal svg size 900," << 360 * panels.size() << " dynamic background rgb 'white'\n"
      << "if (kind eq 'pdf') set terminal pdfcairo size 6," << 2.4 * static_cast<double>(panels.size()) << " font ',10'\n"
      << "if (kind eq 'tikz') set terminal cairolatex pdf size 6," << 2.4 * static_cast<double>(panels.size()) << "\n"
      << "set output '" << name << ".'.(kind eq 'tikz' ? 'tex' : kind)\n"
      << "set datafile separator ','\nset grid lc rgb '#dddddd'\nset key outside right top\n"
      << "set multiplot layout " << panels.size() << ",1 title \"" << title << "\" noenhanced\n";
    for (const Panel& panel : panels) {
        s << "set title \"" << panel.title << "\"\nset xlabel \"" << panel.x_label << "\"\nset ylabel \"" << panel.y_label << "\"\n"
          << "set xrange " << (panel.x_range.empty() ? "[*:*]" : panel.x_range) << "\nplot ";
        for (std::size_t i = 0; i < panel.curves.size(); ++i) {
            const Curve& c = panel.curves[i];
            s << (i ? ", " : "") << "'" << csv << "' using (column('" << panel.x << "')):(column('" << c.y << "')) with " << c.style
              << " lw 2 title \"" << c.title << "\"";
        }
        s << "\n";
    }
    s << "unset multiplot\n";
    const std::string path = folder + "/" + name + ".gp";
    write_file(path, s.str());
    return path;
}

std::string draw_figure(const std::string& folder, const std::string& name, const std::string& kind, std::string& why) {
    const std::string quoted = "'" + folder + "'";
    if (folder.find('\'') != std::string::npos) return why = "a quote in the folder's name", "";
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) return why = "gnuplot is not installed (package gnuplot-nox)", "";
    const std::string command = "cd " + quoted + " && gnuplot -e \"kind='" + kind + "'\" " + name + ".gp >gnuplot.log 2>&1";
    if (std::system(command.c_str()) != 0) return why = "gnuplot failed, see " + folder + "/gnuplot.log", "";
    std::error_code ignored;
    std::filesystem::remove(folder + "/gnuplot.log", ignored);
    return folder + "/" + name + "." + (kind == "tikz" ? "tex" : kind);
}

}  // namespace mpm
