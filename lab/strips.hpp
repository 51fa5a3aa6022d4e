/// Particles in strips of node rows, so that several threads can add to the nodes of one grid with sums that repeat bit for bit.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
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
        if (made_ && particles == numbers_.size() && grid_rows == grid_rows_ && row_length == row_length_ && rows == rows_ &&
            strays_ * 1000 <= particles)
            return;
        resize(particles, grid_rows, row_length, rows);
        in_ranges(threads, particles,
                  [&](std::size_t i) { scratch_[i] = static_cast<std::uint32_t>(first_node(i) / row_length_ / height_); });
        sort();
        made_ = true;
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

    /// Calls visit(reach, i) for each particle: it visits the particle and returns true if its stencil begins within the reach, and else
    /// does nothing and returns false. What visits throw is thrown at the end, that of the lowest particle.
    template <class Visit> void sweep(int threads, Visit&& visit) {
        FirstThrown first;
        for (const int colour : {0, 1})
            in_threads(threads, [&](int k) {
                for (int s = colour; s < count(); s += 2)
                    if (thread_of(s, threads) == k) sweep_strip(s, visit, first);
            });
        gather_strays();
        if (strays_ > 0 && scratch_[0] < first.number())
            visit_all(scratch_.data(), strays_, Reach{0, grid_rows_ * row_length_}, scratch_.data(), visit, first);
        first.rethrow();
    }

private:
    void resize(std::size_t particles, int grid_rows, int row_length, int rows) {
        made_ = false;
        strays_ = 0;
        grid_rows_ = grid_rows, row_length_ = row_length, rows_ = rows;
        height_ = std::max(rows + 1, grid_rows / 64);  // a row of slack or more; strips for many threads
        slack_ = (height_ - (rows - 1)) / 2;
        start_.assign(static_cast<std::size_t>((grid_rows + height_ - 1) / height_) + 1, 0);
        stray_.resize(start_.size());
        scratch_.resize(particles);
        numbers_.resize(particles);
    }

    /// A counting sort, which keeps the order of numbers within a strip.
    void sort() {
        for (const std::uint32_t s : scratch_) ++start_[s + 1];
        for (std::size_t s = 1; s < start_.size(); ++s) start_[s] += start_[s - 1];
        std::copy(start_.begin(), start_.end(), stray_.begin());
        for (std::size_t i = 0; i < scratch_.size(); ++i) numbers_[stray_[scratch_[i]]++] = static_cast<std::uint32_t>(i);
    }

    /// Neighbouring strips share a thread, and threads get about equal numbers of particles.
    int thread_of(int strip, int threads) const {
        const auto s = static_cast<std::size_t>(strip);
        const std::size_t middle = start_[s] + (start_[s + 1] - start_[s]) / 2;
        return start_[s] < start_[s + 1] ? static_cast<int>(middle * static_cast<std::size_t>(threads) / numbers_.size()) : -1;
    }

    template <class Visit> void sweep_strip(int strip, Visit& visit, FirstThrown& first) {
        const auto s = static_cast<std::size_t>(strip);
        stray_[s] = visit_all(&numbers_[start_[s]], start_[s + 1] - start_[s], reach(strip), &scratch_[start_[s]], visit, first);
    }

    /// Writes the strays to `stray` and returns how many. Compiled once, and with the visit in it: calls would cost as much as what they
    /// do.
    template <class Visit> [[gnu::noinline, gnu::flatten]] static std::uint32_t visit_all(const std::uint32_t* numbers, std::size_t count,
                                                                                          Reach reach, std::uint32_t* stray, Visit& visit,
                                                                                          FirstThrown& first) {
        std::uint32_t strays = 0;
        std::size_t k = 0;
        try {
            for (; k < count; ++k)
                if (!visit(reach, std::size_t{numbers[k]})) stray[strays++] = numbers[k];
        } catch (...) {
            first.caught(numbers[k]);
        }
        return strays;
    }

    /// To the front of `scratch_`, in the order of their numbers.
    void gather_strays() {
        strays_ = 0;
        for (std::size_t s = 0; s + 1 < start_.size(); ++s)
            for (std::size_t k = 0; start_[s] < start_[s + 1] && k < stray_[s]; ++k) scratch_[strays_++] = scratch_[start_[s] + k];
        std::sort(scratch_.begin(), scratch_.begin() + static_cast<std::ptrdiff_t>(strays_));
    }

    bool made_ = false;
    int grid_rows_ = 0, row_length_ = 1, rows_ = 1, height_ = 1, slack_ = 0;
    std::size_t strays_ = 0;
    std::vector<std::uint32_t> numbers_;        // of the particles, strip by strip
    std::vector<std::uint32_t> start_, stray_;  // of each strip: its first place in `numbers_`, its number of strays
    std::vector<std::uint32_t> scratch_;        // the strips of the particles, later the strays of each strip at the strip's place
};

}  // namespace mpm
