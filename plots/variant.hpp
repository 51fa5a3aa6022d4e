/// What is compared: programs with options, checked against the programs that the build made and what each says of itself.
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lab/csv_read.hpp"

namespace mpm {

using Words = std::vector<std::string>;
std::string joined(const Words& words, const std::string& between);

/// One program with its options, as given after "--".
struct Variant {
    std::string program;
    Words words;                                                // as given
    std::vector<std::pair<std::string, std::string>> settings;  // name and value of each; "true" for a flag

    std::string options() const;                       // "mode=1;shape=cubic"
    std::string file_name() const;                     // "musl_bar_mode-1_shape-cubic", unlike that of any other variant
    std::map<std::string, std::string> defaults = {};  // of all options of the program
    std::string value(const std::string& name) const;  // as given, or the default; "" for an option that it does not have
};

/// Splits a command line at each "--": the words before the first one, and the variants.
std::pair<Words, std::vector<Words>> split_variants(int argc, const char* const* argv);

/// Names for legends: the program, and of its options those which are not the same for all variants. `shared` gets the others.
Words short_names(const std::vector<Variant>& variants, std::string& shared);

/// A text that can name a file: letters, digits and ._+- stay; with a hash where something was lost or cut.
std::string file_safe(const std::string& text, std::size_t limit = 60);

/// "written to FOLDER: names", for files in it.
std::string written(const std::string& folder, const Words& files);

/// The programs of a build: those which its list (programs.txt) names.
class Programs {
public:
    /// `folder`: "" for that of the running program. Throws FileTrouble.
    explicit Programs(const std::string& folder);

    const Words& names() const { return names_; }
    std::string path(const std::string& name) const;    // throws BadInput with the nearest name
    const CsvTable& describe(const std::string& name);  // the program's --describe; throws FileTrouble
    bool accepts(const std::string& name, const std::string& option);

    /// Checks the program and the names of its options; `managed` are options that the caller sets itself. Throws BadInput.
    Variant variant(const Words& words, const Words& managed);
    /// What `--dry-run` with these words says against the values, where the program can be asked: throws BadInput with its line.
    void check_values(const Variant& variant, const Words& more);

private:
    std::string folder_;
    Words names_;
    std::map<std::string, CsvTable> described_;
};

}  // namespace mpm
