#include "ui/jobs/background_job.h"

#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>

namespace sandbox {
namespace {

void nobody_sleeps() {}

void wait_for_end(const BackgroundJob &job) {
    while (job.state() == JobState::running) {
        std::this_thread::yield();
    }
}

TEST(BackgroundJob, EndsAndSaysSo) {
    std::atomic<int> wakes{0};
    int result = 0;
    BackgroundJob job([&](JobReporter &) { result = 7; }, [&] { ++wakes; });
    wait_for_end(job);
    EXPECT_EQ(job.state(), JobState::done);
    EXPECT_EQ(result, 7);
    EXPECT_EQ(job.take_news(), News::result);
    EXPECT_EQ(job.take_news(), News::none) << "news are told once";
    EXPECT_FALSE(job.cancelled());
}

TEST(BackgroundJob, BringsItsErrorBack) {
    BackgroundJob job([](JobReporter &) { throw std::runtime_error("no such light"); }, nobody_sleeps);
    wait_for_end(job);
    EXPECT_EQ(job.state(), JobState::failed);
    EXPECT_EQ(job.error(), "no such light");
    EXPECT_EQ(job.take_news(), News::result);
}

TEST(BackgroundJob, TellsHowFarItIs) {
    std::atomic<bool> said{false}, seen{false};
    BackgroundJob job(
        [&](JobReporter &reporter) {
            reporter.say("drawing");
            reporter.report(0.25);
            said = true;
            while (!seen) {
                std::this_thread::yield();
            }
            reporter.report(7); // no share
        },
        nobody_sleeps);
    while (!said) {
        std::this_thread::yield();
    }
    EXPECT_EQ(job.state(), JobState::running);
    EXPECT_EQ(job.progress().share, 0.25);
    EXPECT_EQ(job.progress().doing, "drawing");
    seen = true;
    wait_for_end(job);
    EXPECT_EQ(job.progress().share, 1);
}

TEST(BackgroundJob, CancelIsHeardAndWhatWasDoneStays) {
    int rounds = 0;
    BackgroundJob job(
        [&](JobReporter &reporter) {
            do {
                ++rounds;
            } while (reporter.report(0));
        },
        nobody_sleeps);
    job.cancel();
    wait_for_end(job);
    EXPECT_EQ(job.state(), JobState::done) << "stopping is no failure";
    EXPECT_TRUE(job.cancelled());
    EXPECT_GE(rounds, 1);
}

TEST(BackgroundJob, WakesFarLessOftenThanItReports) {
    std::atomic<int> wakes{0};
    BackgroundJob job(
        [](JobReporter &reporter) {
            for (int i = 0; i < 20000; ++i) {
                reporter.report(i / 20000.0);
            }
        },
        [&] { ++wakes; });
    wait_for_end(job);
    // 20000 reports take milliseconds; even on a machine a thousand times slower most of them are silent.
    EXPECT_LT(wakes, 1000);
}

TEST(BackgroundJob, DestroyingItStopsIt) {
    std::atomic<bool> ended{false};
    {
        const BackgroundJob job(
            [&](JobReporter &reporter) {
                while (reporter.report(0.5)) {
                    std::this_thread::yield();
                }
                ended = true;
            },
            nobody_sleeps);
    }
    EXPECT_TRUE(ended);
}

} // namespace
} // namespace sandbox
