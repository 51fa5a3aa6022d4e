/// Work shared by several threads.
#pragma once
#include <atomic>
#include <cstddef>
#include <exception>
#include <limits>
#include <type_traits>

namespace mpm {

namespace detail {
void run_in_threads(int threads, void (*call)(void* part, int k), void* part);
}

/// Calls part(k) for k = 0 ... threads - 1, spread over that many threads (the caller is one), and waits for all; at most 65535. A part
/// must not throw; see FirstThrown. Calls within a part run in its own thread.
template <class Part> void in_threads(int threads, Part&& part) {
    using Type = std::remove_reference_t<Part>;
    detail::run_in_threads(
        threads, [](void* p, int k) { (*static_cast<Type*>(p))(k); }, const_cast<std::remove_const_t<Type>*>(&part));
}

/// Of what is thrown for several numbers in several threads, keeps that of the lowest number, so that a failure repeats its message.
class FirstThrown {
public:
    /// To be called where an exception was caught.
    void caught(std::size_t number);
    /// Lowest number so far; the largest there is if nothing was thrown.
    std::size_t number() const { return number_; }
    /// Throws what was kept, if anything.
    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

private:
    std::size_t number_ = std::numeric_limits<std::size_t>::max();
    std::exception_ptr thrown_;
};

namespace detail {
/// The loop of one thread or of all work, with the visit in it: calls would cost as much as what they do. Compiled once for both. What a
/// visit throws is kept in `first`, if that is given.
template <class Visit> [[gnu::noinline, gnu::flatten]] void visit_range(std::size_t i, std::size_t end, Visit& visit, FirstThrown* first) {
    try {
        for (; i < end; ++i) visit(i);
    } catch (...) {
        if (!first) throw;
        first->caught(i);
    }
}
}  // namespace detail

/// Calls visit(i) for i = 0 ... count - 1, equal ranges of numbers in each thread. Rethrows the exception of the lowest number.
template <class Visit> void in_ranges(int threads, std::size_t count, Visit&& visit) {
    if (threads == 1) return detail::visit_range(0, count, visit, nullptr);
    FirstThrown first;
    const auto parts = static_cast<std::size_t>(threads);
    in_threads(threads, [&](int k) {
        const auto part = static_cast<std::size_t>(k);
        detail::visit_range(count * part / parts, count * (part + 1) / parts, visit, &first);
    });
    first.rethrow();
}

/// The lowest i below `count` for which test(i) is true, else `count`. A test must not throw.
template <class Test> std::size_t first_where(int threads, std::size_t count, Test&& test) {
    std::atomic<std::size_t> lowest = count;
    const auto parts = static_cast<std::size_t>(threads);
    in_threads(threads, [&](int k) {
        const std::size_t part = static_cast<std::size_t>(k), end = count * (part + 1) / parts;
        std::size_t i = count * part / parts;
        while (i < end && !test(i)) ++i;
        if (i == end) return;
        for (std::size_t known = lowest; i < known && !lowest.compare_exchange_weak(known, i);) {
        }
    });
    return lowest;
}

}  // namespace mpm
