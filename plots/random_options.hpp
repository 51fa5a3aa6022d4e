/// Random settings of a program, made of what its --describe says.
#pragma once
#include <random>
#include <string>
#include <vector>

#include "lab/csv_read.hpp"
#include "plots/variant.hpp"

namespace mpm {

using Random = std::mt19937_64;

/// One option as --describe tells it.
struct DescribedOption {
    std::string name, type, initial;
    double low, high;  // -inf and inf where there is no end
    Words choices;
};
std::vector<DescribedOption> described_options(const CsvTable& described);

/// Words for about a third of the options, each value within the range that the program names. They may still not go together, which is the
/// program's to say. Options that say where to write and how much are not among them.
Words random_settings(const std::vector<DescribedOption>& options, Random& random);

/// The same with one thing wrong: an unknown name, a value out of its range or of another type, a missing value, a stray word.
Words wrong_settings(const std::vector<DescribedOption>& options, Random& random);

}  // namespace mpm
