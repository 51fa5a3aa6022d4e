/// What the command line of fbar_block says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/locking/fbar.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/cook.hpp"
#include "lab/program.hpp"

namespace mpm {

struct FbarBlockSettings {
    Common common;
    CookSettings cook;
    std::string scheme = "musl";
};

Assembled musl_block(const FbarBlockSettings& settings, int cells);
Assembled tlmpm_block(const FbarBlockSettings& settings, int cells);

}  // namespace mpm
