#include "lab/study.hpp"

#include <cstdio>

namespace mpm {

void Study::declare(Options& options) {
    options.text("out", out, "folder of the run; empty: out/<program>/<label>");
    options.text("label", label, "name of the run; empty: made of the options that differ");
    options.choice("plot", plot, {"none", "png", "svg", "pdf", "tikz"}, "picture to draw");
    options.flag("quiet", quiet, "say nothing but errors");
    for (const char* name : {"out", "label", "plot", "quiet"}) options.unlabelled(name);
}

void say_written(const std::vector<std::string>& files) {
    std::printf("written:");
    for (const std::string& file : files) std::printf(" %s", file.c_str());
    std::printf("\n");
}

}  // namespace mpm
