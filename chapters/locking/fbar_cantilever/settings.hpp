/// What the command line of fbar_cantilever says, and one function for each scheme, each in a translation unit of its own.
#pragma once
#include <string>

#include "chapters/locking/fbar.hpp"
#include "chapters/material/neo_hookean.hpp"
#include "chapters/scenes/sudden_cantilever.hpp"
#include "lab/program.hpp"

namespace mpm {

using LockingLaw = Fbar<NeoHookean>;

struct FbarCantileverSettings {
    Common common;
    SuddenCantileverSettings beam;
    std::string scheme = "musl";
};

Assembled musl_cantilever(const FbarCantileverSettings& settings, int cells);
Assembled usl_cantilever(const FbarCantileverSettings& settings, int cells);
Assembled tlmpm_cantilever(const FbarCantileverSettings& settings, int cells);

}  // namespace mpm
