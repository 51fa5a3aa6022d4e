/// Large arrays in large pages: walking through hundreds of megabytes in pages of 4 kB costs a fifth of a step in misses of the table of pages.
#pragma once
#include <cstddef>
#include <vector>

namespace mpm {

/// Asks the system for large pages, where it has them; does nothing for small areas. To be called before the memory is first written to.
/// Throws std::bad_alloc for more than the machine has: the system would grant it, and kill the run that uses it.
void advise_large_pages(void* start, std::size_t bytes);

/// Room for n elements of an empty vector, in large pages if it is large.
template <class T> void reserve_large(std::vector<T>& v, std::size_t n) {
    v.reserve(n);
    advise_large_pages(v.data(), n * sizeof(T));
}

}  // namespace mpm
