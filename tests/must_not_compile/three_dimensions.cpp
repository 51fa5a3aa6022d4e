// A stencil in three dimensions.
// must say: stencils are written for one and two dimensions
#include "chapters/weighting/hat.hpp"
#include "chapters/weighting/tensor.hpp"

int main() { mpm::Tensor<3, mpm::Hat>{}.at(mpm::Vec<3>::Zero(), 0); }
