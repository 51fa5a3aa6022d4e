/// The tables of extreme cases (plots/extremes.txt): which variants stand in the columns, what each row asks of them, and which error is
/// allowed, with the reason. Lines of fields with | between them, # begins a comment:
///   table NAME | TITLE
///   column NAME | what to write in two lines (then: the same) | further words of its commands
///   scene NAME | COLUMN, COLUMN ... or * | program with words, or  none: reason
///   case  GROUP | VALUE | SCENE | words | ERROR | BOUND | reason of the bound [| full: not with --quick]
///   limit GROUP | VALUE | SCENE | words                             the largest stable time step
///   known GROUP | VALUE or * | COLUMN, COLUMN ... | cause              why a cell is over its bound, which is no secret
///   step  GROUP | VALUE | SCENE | words | ERROR | BOUND | reason | PART   at this part of it: stable if it is below 1, else not
#pragma once
#include <map>
#include <string>
#include <vector>

#include "plots/variant.hpp"

namespace mpm {

struct CaseColumn {
    std::string name, shown;
    Words words;
};

struct ExtremeCase {
    enum class Kind { run, limit, step } kind = Kind::run;
    std::string group, value, scene;
    Words words;
    std::string error;    // its name
    double bound = 0;     // largest error allowed
    std::string why;      // reason of the bound
    double part = 0;      // of the largest stable step
    bool quick = true;    // also with --quick
};

struct CaseTable {
    std::string name, title;
    std::vector<CaseColumn> columns;
    std::map<std::string, std::map<std::string, std::string>> scenes;  // by name, then by column or "*"
    std::vector<ExtremeCase> cases;
    std::map<std::string, std::string> causes;  // by group, value and column

    /// What is known of a cell that is over its bound; "" where nothing is.
    std::string known(const ExtremeCase& row, const CaseColumn& column) const;
    /// Program and words of a cell; none and why, if the column does not offer the scene.
    Words command(const ExtremeCase& row, const CaseColumn& column, std::string& why_not) const;
};

/// Throws BadInput with the line for what it cannot read.
std::vector<CaseTable> read_case_tables(const std::string& text, const std::string& name);

}  // namespace mpm
