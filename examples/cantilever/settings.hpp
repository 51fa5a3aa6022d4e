/// What the command line of cantilever says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/scenes/cantilever.hpp"
#include "lab/program.hpp"

namespace mpm {

struct CantileverSettings {
    Common common;
    Cantilever beam;
    std::string scheme = "tlmpm";
};

Assembled musl_cantilever(const CantileverSettings& settings, int cells);
Assembled tlmpm_cantilever(const CantileverSettings& settings, int cells);

}  // namespace mpm
