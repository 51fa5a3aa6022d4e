/// A scheme by name with the shapes that suit it, for `--scheme` of examples that put schemes side by side.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "chapters/weighting/shapes.hpp"
#include "lab/program.hpp"

namespace mpm {

template <class Settings> struct SchemeChoice {
    const char* name;
    std::vector<std::string> shapes;
    Assembled (*assemble)(const Settings&, int cells);
};

template <class Settings> std::vector<std::string> scheme_names(const std::vector<SchemeChoice<Settings>>& choices) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.emplace_back(choice.name);
    return names;
}

/// The scheme of that name. Throws BadInput if the shape does not suit it.
template <class Settings>
const SchemeChoice<Settings>& chosen(const std::vector<SchemeChoice<Settings>>& choices, const std::string& name,
                                     const std::string& shape) {
    const auto& choice = *std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.name == name; });
    if (std::find(choice.shapes.begin(), choice.shapes.end(), shape) == choice.shapes.end()) {
        std::string names;
        for (const std::string& suited : choice.shapes) names += (names.empty() ? "" : ", ") + suited;
        throw BadInput("--shape " + shape + ": allowed with --scheme " + name + ": " + names);
    }
    return choice;
}

/// What does not go together in examples whose total-Lagrangian scheme alone has two flavours and all transfers. Throws BadInput.
template <class Settings> void check_settings(const Settings& s) {
    if (s.stress != "musl" && s.scheme != "tlmpm") throw BadInput("--stress: only --scheme tlmpm has two flavours, not " + s.scheme);
    s.transfer.check(s.common.ppc);
    if (s.transfer.name != "flip" && s.scheme != "tlmpm")
        throw BadInput("--transfer " + s.transfer.name + ": allowed with --scheme tlmpm, not " + s.scheme);
    const bool gimp = s.common.shape == Ugimp::name || s.common.shape == Cpgimp::name;
    if (gimp && s.scene.placing == "gauss" && s.common.ppc > 2)
        throw BadInput("--points gauss with --shape " + s.common.shape + ": particles of one size tile a cell only with --ppc 1 or 2");
    s.scene.check();
}

}  // namespace mpm
