/// What sliding_block and rolling_disk share: their options and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/contact/choice.hpp"
#include "chapters/scenes/slope.hpp"
#include "lab/program.hpp"

namespace mpm {

struct SlopeRun {
    Common common;
    SlopeSettings slope;
    ContactChoice contact;
    std::string scheme = "usf";
    bool disk = false;
};

Assembled usl_slope(const SlopeRun& settings, int cells);
Assembled usf_slope(const SlopeRun& settings, int cells);
Assembled musl_slope(const SlopeRun& settings, int cells);

/// The `main` body of both.
int slope_program(const char* program, const char* purpose, bool disk, int argc, char** argv);

}  // namespace mpm
