#include "lab/threads.hpp"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace mpm {
namespace {

/// Waits until `value` is no longer `old`: awake for some microseconds, as long as a short serial piece takes, then asleep. OpenMP's
/// threads stay awake for milliseconds, which costs a hundredfold when other programs want the processor.
void wait_while(const std::atomic<int>& value, int old) {
    for (int k = 0; k < 10000; ++k)
        if (value.load(std::memory_order_acquire) != old) return;
    while (value.load(std::memory_order_acquire) == old) value.wait(old, std::memory_order_acquire);
}

thread_local bool at_work = false;  // in a part

/// Threads that sleep between calls; the caller is the first of them. Whoever is awake takes the next part, so that nobody waits for a
/// thread that the system has not woken yet.
class Team {
public:
    ~Team() {
        ended_ = true;
        next_call();
        for (std::thread& member : members_) member.join();
    }

    void run(int parts, void (*call)(void*, int), void* what) {
        const std::lock_guard one_caller(calls_);
        grow(parts);
        call_ = call, what_ = what;
        left_.store(parts, std::memory_order_relaxed);
        const auto number = static_cast<std::uint64_t>(static_cast<std::uint32_t>(call_number_.load(std::memory_order_relaxed)));
        turn_.store(number << 32 | static_cast<std::uint64_t>(parts) << 16, std::memory_order_release);
        next_call();
        take_parts();
        for (int left; (left = left_.load(std::memory_order_acquire)) > 0;) wait_while(left_, left);
    }

private:
    void next_call() {
        call_number_.fetch_add(1, std::memory_order_release);
        call_number_.notify_all();
    }
    /// With fewer threads than parts, those that are there take them all.
    void grow(int parts) {
        try {
            while (static_cast<int>(members_.size()) + 1 < parts) members_.emplace_back(&Team::work, this, call_number_.load());
        } catch (const std::system_error&) {
        }
    }
    /// A part that was taken belongs to the present call, which does not end before the part is done.
    void take_parts() {
        at_work = true;
        for (std::uint64_t turn = turn_.load(std::memory_order_acquire); (turn & 0xffff) < (turn >> 16 & 0xffff);) {
            if (!turn_.compare_exchange_weak(turn, turn + 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
            call_(what_, static_cast<int>(turn & 0xffff));
            if (left_.fetch_sub(1, std::memory_order_acq_rel) == 1) left_.notify_one();
            turn = turn_.load(std::memory_order_acquire);
        }
        at_work = false;
    }
    void work(int seen) {
        for (;;) {
            wait_while(call_number_, seen);
            seen = call_number_.load(std::memory_order_acquire);
            if (ended_) return;
            take_parts();
        }
    }

    std::mutex calls_;
    std::vector<std::thread> members_;
    std::atomic<int> call_number_ = 0, left_ = 0;  // calls so far; parts of this one that are not done
    std::atomic<std::uint64_t> turn_ = 0;          // the call in the upper half, its parts, the next part to take
    std::atomic<bool> ended_ = false;
    void (*call_)(void*, int) = nullptr;
    void* what_ = nullptr;
};

}  // namespace

void detail::run_in_threads(int threads, void (*call)(void* part, int k), void* part) {
    if (threads == 1 || at_work) {
        for (int k = 0; k < threads; ++k) call(part, k);
        return;
    }
    static Team team;
    team.run(threads, call, part);
}

void FirstThrown::caught(std::size_t number) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    if (number >= number_) return;
    number_ = number;
    thrown_ = std::current_exception();
}

}  // namespace mpm
