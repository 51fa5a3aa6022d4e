// Compiled once for all test files: the headers that take longest, and the number of the mutant that runs (0: none).
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstdlib>

inline const int mutant = std::getenv("MUTANT") == nullptr ? 0 : std::atoi(std::getenv("MUTANT"));
