#include "reference/parallel.h"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace sandbox {
namespace {

TEST(ParallelFor, CallsEveryIndexOnce) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
        std::vector<std::atomic<int>> calls(count);
        parallel_for(count, [&](std::size_t i) { ++calls[i]; });
        EXPECT_TRUE(std::ranges::all_of(calls, [](const auto &n) { return n == 1; })) << count;
    }
}

TEST(ParallelFor, TheThreadsStayTheSame) {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    for (int call = 0; call < 200; ++call) {
        parallel_for(64, [&](std::size_t) {
            const std::lock_guard lock(mutex);
            threads.insert(std::this_thread::get_id());
        });
    }
    EXPECT_LE(threads.size(), std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ParallelFor, LoopsWithinLoopsOfSeveralThreadsEnd) {
    std::atomic<int> calls = 0;
    {
        std::vector<std::jthread> callers;
        for (int caller = 0; caller < 4; ++caller) {
            callers.emplace_back([&] {
                for (int turn = 0; turn < 20; ++turn) {
                    parallel_for(5, [&](std::size_t) {
                        parallel_for(3, [&](std::size_t) { parallel_for(2, [&](std::size_t) { ++calls; }); });
                    });
                }
            });
        }
    }
    EXPECT_EQ(calls, 4 * 20 * 5 * 3 * 2);
}

TEST(ParallelFor, AnExceptionComesOutOnceAllHaveStopped) {
    for (int turn = 0; turn < 50; ++turn) {
        std::atomic<int> inside = 0;
        const auto work = [&](std::size_t i) {
            ++inside;
            std::this_thread::yield();
            --inside;
            if (i == 30) {
                throw std::out_of_range("thirty");
            }
        };
        EXPECT_THROW(parallel_for(1000, work), std::out_of_range);
        EXPECT_EQ(inside, 0);
    }
    EXPECT_THROW(
        parallel_for(4, [](std::size_t) { parallel_for(4, [](std::size_t) { throw std::out_of_range("in"); }); }),
        std::out_of_range);
}

TEST(ParallelFor, ProgressCountsUpAndMayCancel) {
    std::vector<double> shares;
    parallel_for(
        50, [](std::size_t) {},
        [&](double share) {
            shares.push_back(share); // one call at a time
            return true;
        });
    ASSERT_EQ(shares.size(), 50U);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_EQ(shares.back(), 1);
    std::atomic<int> calls = 0;
    EXPECT_THROW(parallel_for(
                     100000, [&](std::size_t) { ++calls; }, [](double share) { return share < 0.001; }),
                 Cancelled);
    EXPECT_LT(calls, 1000);
}

} // namespace
} // namespace sandbox
