#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <type_traits>
#include <vector>

/// Loops on several threads. The caller is one of them; none outlives the call.
namespace braidx {

/// Calls visit(chunk, begin, end) for consecutive chunks of [0, count), one per thread and all of
/// them at once. Chunks depend on the two numbers alone, so that sums per chunk, added up in the
/// order of chunks, are the same in every run. Of several exceptions that of the first chunk goes
/// on to the caller.
template <class Visit>
void parallel_chunks(std::size_t count, int num_threads, const Visit& visit) {
    const auto threads_wanted = static_cast<std::size_t>(std::max(num_threads, 1));
    const std::size_t num_chunks = std::min(count, threads_wanted);
    if (num_chunks == 0)
        return;
    std::vector<std::exception_ptr> failures(num_chunks);
    const auto run = [&](std::size_t chunk) {
        try {
            visit(chunk, count * chunk / num_chunks, count * (chunk + 1) / num_chunks);
        } catch (...) {
            failures[chunk] = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t chunk = 1; chunk < num_chunks; ++chunk)
            others.emplace_back(run, chunk);
        run(0);
    }
    for (const auto& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
}

/// f(i) for every i of [0, count), by whichever thread is free: items may cost unequally.
template <class F> auto parallel_map(std::size_t count, int num_threads, const F& f) {
    std::vector<std::invoke_result_t<F, std::size_t>> out(count);
    const auto num_workers = static_cast<std::size_t>(std::max(num_threads, 1));
    const std::size_t at_a_time = count / (16 * num_workers) + 1;
    std::atomic<std::size_t> next = 0;
    parallel_chunks(num_workers, num_threads, [&](std::size_t, std::size_t, std::size_t) {
        for (std::size_t i = next.fetch_add(at_a_time); i < count; i = next.fetch_add(at_a_time))
            for (std::size_t end = std::min(i + at_a_time, count); i < end; ++i)
                out[i] = f(i);
    });
    return out;
}

} // namespace braidx
