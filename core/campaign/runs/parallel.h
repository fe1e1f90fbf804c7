// Work on many things that do not depend on each other, on all processors.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace usar::campaign {

/// Calls work(0) .. work(count - 1), each once, in any order and in several threads at a time. It returns when all are
/// done. `work` writes only to what belongs to its number; an exception of one of them is thrown here.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
    std::atomic<std::size_t> next{0};
    const auto takeTurns = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    const std::size_t threads = std::min<std::size_t>(count, std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::future<void>> others;
    for (std::size_t i = 1; i < threads; ++i)
        others.push_back(std::async(std::launch::async, takeTurns));
    takeTurns();
    for (std::future<void>& one : others)
        one.get();
}

} // namespace usar::campaign
