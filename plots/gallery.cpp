/// gallery: the page of all figures, figures/index.html.
///   ./gallery --plots plots --figures figures
#include "plots/gallery.hpp"

#include <cstdio>
#include <string>

#include "lab/options.hpp"
#include "lab/program.hpp"

int main(int argc, char** argv) {
    using namespace mpm;
    return guarded("gallery", [&] {
        Options options("gallery", "writes a page of all figures that were drawn, with the commands behind them");
        std::string plots = "plots", figures = "figures";
        options.text("plots", plots, "folder of the recipes and of gallery.txt, which lists chapters and figures");
        options.text("figures", figures, "folder of the figures; the page is its index.html");
        options.parse(argc, argv);
        if (answered(options, "gallery")) return 0;
        write_gallery(plots, figures);
        std::printf("wrote %s/index.html\n", figures.c_str());
        return 0;
    });
}
