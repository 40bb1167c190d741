#include "parallel.h"

#include <catch2/catch_test_macros.hpp>
#include <stdexcept>
#include <string>
#include <vector>

using namespace braidx;

namespace {

constexpr std::size_t counts[] = {0, 1, 2, 3, 7, 100};
constexpr int thread_counts[] = {-1, 0, 1, 2, 3, 8};

} // namespace

TEST_CASE("chunks cover every index once, in order, however many threads there are", "[parallel]") {
    for (const auto count : counts)
        for (const auto num_threads : thread_counts) {
            INFO(count << " items, " << num_threads << " threads");
            const auto most = static_cast<std::size_t>(std::max(num_threads, 1));
            std::vector<std::pair<std::size_t, std::size_t>> ranges(most);
            std::vector<int> visits(most);
            parallel_chunks(count, num_threads, [&](std::size_t chunk, auto begin, auto end) {
                ranges.at(chunk) = {begin, end};
                ++visits.at(chunk);
            });
            std::size_t covered = 0;
            for (std::size_t chunk = 0; chunk < std::min(most, count); ++chunk) {
                CHECK(visits[chunk] == 1);
                CHECK(ranges[chunk].first == covered);
                CHECK(ranges[chunk].second > covered);
                covered = ranges[chunk].second;
            }
            CHECK(covered == count);
        }
}

TEST_CASE("each item is mapped once, to its own place", "[parallel]") {
    for (const auto count : counts)
        for (const auto num_threads : thread_counts) {
            std::vector<int> visits(count);
            const auto squares = parallel_map(count, num_threads, [&](std::size_t i) {
                ++visits.at(i);
                return i * i;
            });
            REQUIRE(squares.size() == count);
            for (std::size_t i = 0; i < count; ++i)
                CHECK(squares[i] == i * i);
            CHECK(visits == std::vector<int>(count, 1));
        }
}

TEST_CASE("each chunk has a thread, the first one the caller's", "[parallel]") {
    std::vector<std::thread::id> ids(3);
    parallel_chunks(
        3, 3, [&](std::size_t chunk, auto, auto) { ids[chunk] = std::this_thread::get_id(); });
    CHECK(ids[0] == std::this_thread::get_id());
    CHECK(ids[1] != ids[0]);
    CHECK(ids[2] != ids[0]);
}

TEST_CASE("exceptions reach the caller after all threads have ended", "[parallel]") {
    for (const int num_threads : {1, 2, 5}) {
        std::atomic<int> ended = 0;
        const auto visit = [&](std::size_t chunk, auto, auto) {
            ++ended;
            throw std::runtime_error(std::to_string(chunk));
        };
        std::string message;
        try {
            parallel_chunks(5, num_threads, visit);
        } catch (const std::runtime_error& error) {
            message = error.what();
        }
        CHECK(message == "0");
        CHECK(ended == num_threads);
        const auto fail = [](std::size_t i) {
            return i == 3 ? throw std::out_of_range("three") : i;
        };
        CHECK_THROWS_AS(parallel_map(5, num_threads, fail), std::out_of_range);
    }
}
