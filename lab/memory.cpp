#include "lab/memory.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <new>

namespace mpm {

void advise_large_pages(void* start, std::size_t bytes) {
    const auto pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    if (pages > 0 && size > 0 && bytes / static_cast<std::size_t>(size) > static_cast<std::size_t>(pages)) throw std::bad_alloc();
    constexpr std::uintptr_t page = std::uintptr_t{2} << 20;  // a large one, of most processors
    const auto address = reinterpret_cast<std::uintptr_t>(start);
    const std::uintptr_t first = (address + page - 1) / page * page, end = (address + bytes) / page * page;
    if (end > first) static_cast<void>(madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE));  // an advice, no more
}

}  // namespace mpm
