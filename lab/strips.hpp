/// Particles in strips of node rows, so that several threads can add to the nodes of one grid with sums that repeat bit for bit.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "lab/threads.hpp"

namespace mpm {

/// A particle belongs to the strip of the lowest node row that it touches. Strips are so high that even ones share no node, nor do odd
/// ones: the threads take the even strips, then the odd ones, and visit the particles of a strip in the order of their numbers. Strips
/// depend on grid and particles alone, hence the sums are the same for every number of threads above one.
///
/// Strips have `slack` rows to spare and are kept while particles drift: one that went further is a stray, visited after the others in one
/// thread. Many strays call for new strips. So nothing rests on who moved the particles, or when.
class Strips {
public:
    /// Sorts the particles into strips unless those at hand will do. `first_node(i)` is the lowest node of particle i, `rows` the number of
    /// node rows that a particle touches; the grid has `grid_rows` of `row_length` nodes. Nothing is allocated while these numbers stay.
    template <class FirstNode>
    void prepare(std::size_t particles, int grid_rows, int row_length, int rows, int threads, FirstNode&& first_node) {
        if (will_do(particles, grid_rows, row_length, rows)) return;
        resize(particles, grid_rows, row_length, rows);
        in_ranges(threads, particles, [&](std::size_t i) { scratch_[i] = static_cast<std::uint32_t>(first_node(i)); });
        sort();
    }
    /// Asks for new strips: the particles have other numbers now.
    void forget() { made_ = false; }

    int count() const { return static_cast<int>(start_.size()) - 1; }
    int height() const { return height_; }          // of a strip [node rows]
    int slack() const { return slack_; }            // [node rows]
    std::size_t strays() const { return strays_; }  // in the last sweep

    /// The nodes at which the stencils of a strip may begin.
    struct Reach {
        int lowest, count;
        bool holds(int node) const { return node >= lowest && node - lowest < count; }
    };
    Reach reach(int strip) const { return {(strip * height_ - slack_) * row_length_, (height_ + 2 * slack_) * row_length_}; }

    /// Some particles for one thread: numbers[begin] ... numbers[end - 1], or the numbers themselves where there is no list. Those whose
    /// stencils do not begin within the reach are no part of it; their numbers go to `strays`.
    struct Part {
        std::size_t begin, end;
        const std::uint32_t* numbers = nullptr;
        Reach reach = {0, std::numeric_limits<int>::max()};
        std::uint32_t* strays = nullptr;
        FirstThrown* first = nullptr;  // keeps what is thrown; without it, it is thrown on
        std::size_t number(std::size_t k) const { return numbers ? numbers[k] : k; }
    };

    /// Calls visit(part), which returns how many strays it wrote, for parts that together hold each particle once. What visits throw is
    /// thrown at the end, that of the lowest particle.
    template <class Visit> void sweep(int threads, Visit&& visit) {
        using Type = std::remove_reference_t<Visit>;
        sweep(threads, [](void* v, const Part& part) { return (*static_cast<Type*>(v))(part); }, &visit);
    }

private:
    void sweep(int threads, std::uint32_t (*visit)(void* what, const Part&), void* what);
    bool will_do(std::size_t particles, int grid_rows, int row_length, int rows) const;
    void resize(std::size_t particles, int grid_rows, int row_length, int rows);
    void sort();
    int thread_of(int strip, int threads) const;
    void gather_strays();

    bool made_ = false;
    int grid_rows_ = 0, row_length_ = 1, rows_ = 1, height_ = 1, slack_ = 0;
    std::size_t strays_ = 0;
    std::vector<std::uint32_t> numbers_;        // of the particles, strip by strip
    std::vector<std::uint32_t> start_, stray_;  // of each strip: its first place in `numbers_`, its number of strays
    std::vector<std::uint32_t> scratch_;        // the strips of the particles, later the strays of each strip at the strip's place
};

}  // namespace mpm
