/// Settings as the user wrote them, from the command line (Boost.Program_options) and a config file. For lab/options.cpp only.
#pragma once
#include <string>
#include <vector>

namespace mpm::detail {

/// One setting as the user wrote it; `who` names it in messages ("--nu", "case.ini:3: nu").
struct Setting {
    std::string name, who, raw;
};

/// Options that every program has and no config file holds.
inline const std::vector<std::string> always = {"help", "version", "describe", "config"};

/// The settings of `--config FILE`, then those of the command line. `names` are the program's options, `flags` those of them that take no
/// value.
std::vector<Setting> read_settings(int argc, const char* const* argv, const std::vector<std::string>& names,
                                   const std::vector<std::string>& flags);

}  // namespace mpm::detail
