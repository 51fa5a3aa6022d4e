/// A matrix of cells with a number or a word in each: the figures of `extremes`.
#pragma once
#include <string>
#include <vector>

#include "plots/extreme_cases.hpp"

namespace mpm {

/// <table>.csv with <table>.gp in the folder: rows are cases, columns variants. Cells that are not offered carry a letter, which a line
/// below the matrix explains. Returns the name of the figure.
std::string write_matrix(const std::string& folder, const CaseTable& table, const std::vector<ExtremeCase>& cases,
                         const std::vector<std::vector<Cell>>& cells, std::vector<std::string>& files);

struct Footnotes;
/// What stands in a cell.
std::string text_of(const Cell& cell, Footnotes& notes);

/// Letters for the reasons of cells that are not offered, in order of appearance; and the lines that explain them.
struct Footnotes {
    std::vector<std::string> reasons;
    std::string letter(const std::string& reason);
};

}  // namespace mpm
