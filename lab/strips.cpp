#include "lab/strips.hpp"

#include <algorithm>

namespace mpm {

bool Strips::will_do(std::size_t particles, int grid_rows, int row_length, int rows) const {
    return made_ && particles == numbers_.size() && grid_rows == grid_rows_ && row_length == row_length_ && rows == rows_ &&
           strays_ * 1000 <= particles;
}

void Strips::resize(std::size_t particles, int grid_rows, int row_length, int rows) {
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

/// `scratch_` holds the particles' lowest nodes. A counting sort, which keeps the order of numbers within a strip.
void Strips::sort() {
    const auto nodes = static_cast<std::uint32_t>(row_length_ * height_);  // of a strip
    for (std::uint32_t& first : scratch_) ++start_[(first /= nodes) + 1];
    for (std::size_t s = 1; s < start_.size(); ++s) start_[s] += start_[s - 1];
    std::copy(start_.begin(), start_.end(), stray_.begin());
    for (std::size_t i = 0; i < scratch_.size(); ++i) numbers_[stray_[scratch_[i]]++] = static_cast<std::uint32_t>(i);
    made_ = true;
}

/// Neighbouring strips share a thread, and threads get about equal numbers of particles.
int Strips::thread_of(int strip, int threads) const {
    const auto s = static_cast<std::size_t>(strip);
    const std::size_t middle = start_[s] + (start_[s + 1] - start_[s]) / 2;
    return start_[s] < start_[s + 1] ? static_cast<int>(middle * static_cast<std::size_t>(threads) / numbers_.size()) : -1;
}

void Strips::sweep(int threads, std::uint32_t (*visit)(void* what, const Part&), void* what) {
    FirstThrown first;
    for (const int colour : {0, 1})
        in_threads(threads, [&](int k) {
            for (int strip = colour; strip < count(); strip += 2) {
                if (thread_of(strip, threads) != k) continue;
                const auto s = static_cast<std::size_t>(strip);
                stray_[s] = visit(what, Part{start_[s], start_[s + 1], numbers_.data(), reach(strip), &scratch_[start_[s]], &first});
            }
        });
    gather_strays();
    const Reach all{0, grid_rows_ * row_length_};
    if (strays_ > 0 && scratch_[0] < first.number()) visit(what, Part{0, strays_, scratch_.data(), all, scratch_.data(), &first});
    first.rethrow();
}

/// To the front of `scratch_`, in the order of their numbers.
void Strips::gather_strays() {
    strays_ = 0;
    for (std::size_t s = 0; s + 1 < start_.size(); ++s)
        for (std::size_t k = 0; start_[s] < start_[s + 1] && k < stray_[s]; ++k) scratch_[strays_++] = scratch_[start_[s] + k];
    std::sort(scratch_.begin(), scratch_.begin() + static_cast<std::ptrdiff_t>(strays_));
}

}  // namespace mpm
